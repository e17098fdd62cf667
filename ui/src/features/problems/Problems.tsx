import { useEffect } from "react";
import { Button } from "../../shared/controls/Button";
import { Mark } from "../../shared/lists/Mark";
import { dismiss, type Problem, useProblems } from "../../state/asking/problems";
import "./problems.css";

/** News goes by itself; what is wrong stays until it was read. */
const NEWS_MS = 8000;
/** More at once hide the work. */
const MAX = 4;

function One({ problem }: { readonly problem: Problem }) {
  const { id, severity, message } = problem;
  useEffect(() => {
    if (severity !== "info") return;
    const timer = setTimeout(() => dismiss(id), NEWS_MS);
    return () => clearTimeout(timer);
  }, [id, severity]);
  return (
    <li className={`problem ${severity}`}>
      <Mark tone={severity} />
      <p className="selectable">{message}</p>
      <Button kind="quiet" icon="close" small aria-label="Dismiss" onClick={() => dismiss(id)} />
    </li>
  );
}

/** What went wrong, and what a person should know: over the view, read aloud as it comes. */
export function Problems() {
  const problems = useProblems((store) => store.problems);
  return (
    <div className="problems" role="status" aria-live="polite" aria-label="Messages">
      <ul>
        {problems.slice(-MAX).map((problem) => (
          <One key={problem.id} problem={problem} />
        ))}
      </ul>
      {problems.length > MAX && (
        <Button kind="link" onClick={() => problems.slice(0, -1).forEach(({ id }) => dismiss(id))}>
          {problems.length - MAX} more: dismiss all but the last
        </Button>
      )}
    </div>
  );
}
