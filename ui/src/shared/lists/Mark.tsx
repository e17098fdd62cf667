import { Icon } from "../controls/icons";
import "./lines.css";

export type Tone = "error" | "warning" | "fine" | "info";

const WORDS: Readonly<Record<Tone, string>> = { error: "Error", warning: "Warning", fine: "Fine", info: "Note" };

/** A sign for how things stand: a shape and a colour, and a word for those who see neither. */
export function Mark({ tone }: { readonly tone: Tone }) {
  return (
    <span className={`mark ${tone}`}>
      <Icon name={tone} />
      <span className="visually-hidden">{WORDS[tone]}: </span>
    </span>
  );
}
