import { useEffect, useLayoutEffect, useRef, useState } from "react";
import { Button } from "../../shared/controls/Button";
import { Mark } from "../../shared/lists/Mark";
import { dismiss, dismissEverything, type Problem, useProblems } from "../../state/asking/problems";
import { useSelection } from "../../state/design/selection";
import { belongsAtTop } from "./covers";
import "./problems.css";

/** How long they are shown, ms: longer what is worse, and not counted while a person reads them or has the window out of sight. */
const LIFE_MS: Readonly<Record<Problem["severity"], number>> = { info: 8_000, warning: 20_000, error: 40_000 };
/** More at once hide the work. */
const MAX = 3;
/** px that a pointer may tremble. */
const STILL = 3;

/** Whether the window is out of sight. */
function useHidden(): boolean {
  const [hidden, setHidden] = useState(document.hidden);
  useEffect(() => {
    const look = () => setHidden(document.hidden);
    document.addEventListener("visibilitychange", look);
    return () => document.removeEventListener("visibilitychange", look);
  }, []);
  return hidden;
}

/** Has a message go by itself, also one that is not among the latest: it is as old as they are. */
function Ageing({ problem, held }: { readonly problem: Problem; readonly held: boolean }) {
  const { id, severity, stays } = problem;
  useEffect(() => {
    if (held || stays) return;
    const timer = setTimeout(() => dismiss(id), LIFE_MS[severity]);
    return () => clearTimeout(timer);
  }, [held, id, severity, stays]);
  return null;
}

function One({ problem, gone }: { readonly problem: Problem; readonly gone: boolean }) {
  const { id, severity, message } = problem;
  return (
    <li className={`problem ${severity}${gone ? " gone" : ""}`} aria-hidden={gone || undefined}>
      <Mark tone={severity} />
      <p className="selectable">{message}</p>
      <Button kind="quiet" icon="close" small aria-label="Dismiss" onClick={() => dismiss(id)} />
    </li>
  );
}

/**
 * What went wrong, and what a person should know: over the view, read aloud as it comes, the newest on top. While the pointer or the focus
 * is on them none comes, goes or moves.
 */
export function Problems() {
  const problems = useProblems((store) => store.problems);
  const [over, setOver] = useState(false);
  const [focused, setFocused] = useState(false);
  const used = over || focused;
  const hidden = useHidden();
  const entered = useRef({ x: 0, y: 0 });
  const box = useRef<HTMLDivElement>(null);
  const [atTop, setAtTop] = useState(false);
  const [kept, setKept] = useState<readonly Problem[]>([]);
  const latest = problems.slice(-MAX).toReversed();
  // Those that are looked at keep their places until they are not any more; another one comes above them, where there is room.
  const read = kept.filter((problem) => problems.includes(problem));
  const above = latest.filter((problem) => !kept.includes(problem)).slice(0, Math.max(MAX - read.length, 0));
  const shown = used ? [...above, ...kept] : latest;
  const newest = problems.at(-1)?.id ?? null;
  const vertices = useSelection((selection) => selection.vertices);
  const edges = useSelection((selection) => selection.edges);
  // biome-ignore lint/correctness/useExhaustiveDependencies: each message may speak of something else, and so may what is selected
  useLayoutEffect(() => {
    if (newest === null) setAtTop(false);
    // They do not jump while they are read.
    else if (box.current && !used) setAtTop(belongsAtTop(box.current, atTop));
  }, [newest, vertices, edges, used]);
  useLayoutEffect(() => {
    // What is removed or hidden takes the focus with it, and not every engine says so: nobody reads there any more.
    const at = document.activeElement;
    if (!box.current?.contains(at) || at?.closest(".gone")) setFocused(false);
    if (problems.length > 0) return;
    setOver(false);
    setKept([]);
  }, [problems]);
  const keep = () => {
    if (!used) setKept(latest);
  };
  const more = problems.filter((problem) => !shown.includes(problem)).length;
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: it is only looked at
    <div
      ref={box}
      className={atTop ? "problems top" : "problems"}
      // One that comes under a pointer that rests is not looked at: only who moves there reads.
      onPointerEnter={({ clientX, clientY }) => (entered.current = { x: clientX, y: clientY })}
      onPointerMove={({ clientX, clientY }) => {
        const { x, y } = entered.current;
        if (Math.hypot(clientX - x, clientY - y) < STILL) return;
        keep();
        setOver(true);
      }}
      onPointerLeave={() => setOver(false)}
      onFocus={() => {
        keep();
        setFocused(true);
      }}
      onBlur={({ relatedTarget }) => {
        if (!box.current?.contains(relatedTarget)) setFocused(false);
      }}
    >
      {problems.map((problem) => (
        <Ageing key={problem.id} problem={problem} held={used || hidden} />
      ))}
      <div role="status" aria-live="polite" aria-label="Messages">
        <ul>
          {shown.map((problem) => (
            <One key={problem.id} problem={problem} gone={!problems.includes(problem)} />
          ))}
        </ul>
      </div>
      {problems.length > 1 && (
        <div className="problems-all">
          {more > 0 && <span className="muted">{more} more</span>}
          <Button small onClick={dismissEverything}>
            Dismiss all
          </Button>
        </div>
      )}
    </div>
  );
}
