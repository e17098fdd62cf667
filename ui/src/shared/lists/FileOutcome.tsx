import { Button } from "../controls/Button";
import { Line } from "./Line";

/** Why a file was not written; one that is there already may be replaced. */
export function FileProblem({
  problem,
  replace,
}: {
  readonly problem: { readonly exists: boolean; readonly message: string };
  readonly replace: () => void;
}) {
  return (
    <div role="alert">
      <ul>
        <Line
          tone="error"
          what={problem.exists ? "The file exists already" : "The file was not written"}
          sub={problem.exists ? "Confirm to replace it." : problem.message}
          action={
            problem.exists && (
              <Button kind="link" onClick={replace}>
                Replace
              </Button>
            )
          }
        />
      </ul>
    </div>
  );
}

/** Where files were written. */
export function WrittenFiles({ files }: { readonly files: readonly string[] }) {
  return files.map((file) => (
    <p key={file} className="written">
      <span className="muted">Written: </span>
      <span className="selectable">{file}</span>
    </p>
  ));
}
