import { Button } from "../../shared/controls/Button";
import { Checkbox } from "../../shared/controls/inputs";
import { Line } from "../../shared/lists/Line";
import { useDesign } from "../../state/design/design";
import { useUi } from "../../state/window/ui";
import { refusalOf } from "./texts";

/**
 * Why the machine cannot bend the open design, and a box to go on all the same. *Export* and *Run* say it by this alone, so that they say
 * of a wire what *Check* says of it.
 */
export function Anyway({
  checked,
  onChange,
  why,
  children,
}: {
  readonly checked: boolean;
  readonly onChange: (checked: boolean) => void;
  /** Why it cannot be chosen now. */
  readonly why?: string | null;
  /** What is done all the same. */
  readonly children: string;
}) {
  const check = useDesign((design) => design.check);
  const showSection = useUi((ui) => ui.showSection);
  const { sub, consequence } = refusalOf(check);
  return (
    <div className="inset stack">
      <ul>
        <Line
          tone="error"
          what="The machine cannot bend this"
          sub={sub}
          action={
            <Button kind="link" aria-controls="section-check" onClick={() => showSection("check")}>
              Check
            </Button>
          }
        />
      </ul>
      <Checkbox checked={checked} onChange={onChange} why={why ?? null}>
        {children}
      </Checkbox>
      {checked && <p className="muted small">{consequence}</p>}
    </div>
  );
}
