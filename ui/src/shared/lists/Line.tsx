import type { HTMLAttributes, ReactNode } from "react";
import { Mark, type Tone } from "./Mark";
import "./lines.css";

/** One line of what, one grey line of figures, one action. */
export function Line({
  tone,
  what,
  sub,
  action,
  ...rest
}: {
  readonly tone: Tone;
  readonly what: ReactNode;
  readonly sub?: ReactNode;
  readonly action?: ReactNode;
} & HTMLAttributes<HTMLLIElement>) {
  return (
    <li {...rest} className={`line ${rest.className ?? ""}`}>
      <Mark tone={tone} />
      <div className="line-what">{what}</div>
      {sub && <div className="line-sub">{sub}</div>}
      {action && <div className="line-action">{action}</div>}
    </li>
  );
}
