import { type InputHTMLAttributes, type ReactNode, type SelectHTMLAttributes, useId } from "react";
import "./controls.css";
import { Icon, type IconName } from "./icons";

export interface Choice<T extends string> {
  readonly value: T;
  readonly label: string;
  /** Why it cannot be chosen. */
  readonly why?: string | null;
}

/** One of several, in the system's own list. */
export function Select<T extends string>({
  choices,
  value,
  onChoose,
  ...rest
}: { readonly choices: readonly Choice<T>[]; readonly value: T; readonly onChoose: (value: T) => void } & Omit<
  SelectHTMLAttributes<HTMLSelectElement>,
  "value" | "onChange" | "children"
>) {
  return (
    <span className="select">
      <select {...rest} value={value} onChange={(event) => onChoose(event.currentTarget.value as T)}>
        {choices.map((choice) => (
          <option
            key={choice.value}
            value={choice.value}
            disabled={Boolean(choice.why)}
            title={choice.why ?? undefined}
          >
            {choice.label}
          </option>
        ))}
      </select>
      <Icon name="down" size={12} />
    </span>
  );
}

/** A few choices beside each other. */
export function Segmented<T extends string>({
  label,
  choices,
  value,
  onChoose,
}: {
  readonly label: string;
  readonly choices: readonly (Choice<T> & { readonly icon?: IconName })[];
  readonly value: T;
  readonly onChoose: (value: T) => void;
}) {
  const name = useId();
  return (
    <div className="segmented" role="radiogroup" aria-label={label}>
      {choices.map((choice) => (
        <label key={choice.value} title={choice.why ?? undefined} className={choice.why ? "off" : undefined}>
          <input
            type="radio"
            name={name}
            value={choice.value}
            checked={choice.value === value}
            disabled={Boolean(choice.why)}
            onChange={() => onChoose(choice.value)}
          />
          <span>
            {choice.icon && <Icon name={choice.icon} />}
            {choice.label}
          </span>
        </label>
      ))}
    </div>
  );
}

export function Checkbox({
  checked,
  onChange,
  children,
  why,
}: {
  readonly checked: boolean;
  readonly onChange: (checked: boolean) => void;
  readonly children: ReactNode;
  readonly why?: string | null;
}) {
  return (
    <label className={why ? "checkbox off" : "checkbox"} title={why ?? undefined}>
      <input
        type="checkbox"
        checked={checked}
        disabled={Boolean(why)}
        onChange={(event) => onChange(event.currentTarget.checked)}
      />
      <span>{children}</span>
    </label>
  );
}

/** A line of text. */
export function TextInput(props: InputHTMLAttributes<HTMLInputElement>) {
  return (
    <input
      type="text"
      autoComplete="off"
      spellCheck={false}
      {...props}
      className={`text-input ${props.className ?? ""}`}
    />
  );
}

/** A share of 1 to slide. */
export function Slider({
  label,
  value,
  onChange,
  text,
  min = 0,
  max = 1,
  step = 0.01,
}: {
  readonly label: string;
  readonly value: number;
  readonly onChange: (value: number) => void;
  /** Said instead of the number. */
  readonly text?: string;
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
}) {
  const filled = max > min ? ((value - min) / (max - min)) * 100 : 0;
  return (
    <input
      className="slider"
      type="range"
      aria-label={label}
      aria-valuetext={text}
      min={min}
      max={max}
      step={step}
      value={value}
      style={{ "--filled": `${filled}%` } as Record<string, string>}
      onChange={(event) => onChange(Number(event.currentTarget.value))}
    />
  );
}

/** How far something is: `of` 0 where that is not known. */
export function Bar({ done, of, label }: { readonly done: number; readonly of: number; readonly label: string }) {
  return <progress className="bar" aria-label={label} {...(of > 0 ? { value: done, max: of } : {})} />;
}
