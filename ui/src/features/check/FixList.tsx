import { useRef, useState } from "react";
import type { Fix } from "../../generated/responses";
import { Button } from "../../shared/controls/Button";
import { money, signed, time } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { useInSight } from "../../shared/lists/sight";
import { useDesign } from "../../state/design/design";
import { isCollision } from "../../state/design/findings";
import { applyFix, otherWires, showFix, useFixes } from "../../state/design/fixes/fixes";
import { afterwards, isFirst } from "./totals";

/** What changes, in a line: "+601.4 mm · +$1.20 · +2:10"; without a route, what there is then. */
function useChange(): (fix: Fix) => string {
  const { length, long } = useLengths();
  const { limits, check } = useDesign();
  const errorsOf = (of: typeof check) => of?.diagnostics.filter(({ severity }) => severity === "error").length ?? 0;
  return (fix) => {
    const { change, after } = fix;
    const before = errorsOf(isCollision(fix.mends.code) ? check : limits);
    if (isFirst(change)) {
      const parts = [
        after.length_mm !== null && length(after.length_mm),
        after.stock_mm !== null && `stock ${long(after.stock_mm)}`,
        after.time_s !== null && time(after.time_s),
        after.cost !== null && money(after.cost, change.currency),
        afterwards(fix, before),
      ];
      return parts.filter(Boolean).join(" · ");
    }
    const parts = [
      otherWires(fix),
      change.length_mm !== null && Math.abs(change.length_mm) >= 0.05 && signed(change.length_mm, length),
      change.cost !== null &&
        Math.abs(change.cost) >= 0.005 &&
        signed(change.cost, (value) => money(value, change.currency)),
      change.time_s !== null && Math.abs(change.time_s) >= 0.5 && signed(change.time_s, time),
      afterwards(fix, before),
    ];
    return parts.filter(Boolean).join(" · ");
  };
}

/** A fix is of the design as it was looked at: the second click of a double one would make it again of another one. */
function isOutdated(fix: Fix): boolean {
  const { of, ofCollisions } = useFixes.getState();
  const { limits, collisions } = useDesign.getState();
  return isCollision(fix.mends.code) ? ofCollisions !== (collisions?.found ?? null) : of !== limits;
}

/** Changes that would fix it, each tried on a copy before: shown in the view, and made with one click that undo takes back. */
export function FixList({
  fixes,
  isOld = isOutdated,
  note = () => null,
}: {
  readonly fixes: readonly Fix[];
  /** Whether one is of the design as it was. */
  readonly isOld?: (fix: Fix) => boolean;
  /** What else there is to know of one. */
  readonly note?: (fix: Fix) => string | null;
}) {
  // Drawn anew when one of them is another.
  const { shown } = useFixes();
  useDesign();
  const [made, setMade] = useState<Fix | null>(null);
  const change = useChange();
  const box = useRef<HTMLUListElement>(null);
  useInSight(box, true);
  const whyNot = (fix: Fix): string | null => {
    if (made !== null && fixes.includes(made)) return "The fix is being applied.";
    return isOld(fix) ? "The design has changed since." : null;
  };
  const apply = async (fix: Fix) => {
    const before = useDesign.getState().state;
    setMade(fix);
    await applyFix(fix);
    if (useDesign.getState().state === before) setMade(null);
  };
  return (
    <ul ref={box} className="fixes">
      {fixes.map((fix, index) => {
        const now = shown === fix;
        return (
          // biome-ignore lint/suspicious/noArrayIndexKey: the fixes of a finding come and go together
          <li key={index} className="fix">
            <div className="fix-title">{fix.title}</div>
            <div className="muted">{change(fix)}</div>
            {note(fix) && <div className="muted">{note(fix)}</div>}
            <div className="row">
              <Button small pressed={now} onClick={() => showFix(now ? null : fix)}>
                Preview
              </Button>
              <Button small kind="primary" why={whyNot(fix)} onClick={() => void apply(fix)}>
                Apply
              </Button>
            </div>
          </li>
        );
      })}
    </ul>
  );
}
