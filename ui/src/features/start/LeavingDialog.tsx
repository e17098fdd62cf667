import { Button } from "../../shared/Button";
import { Dialog } from "../../shared/Dialog";
import { useDesign } from "../../state/design";
import { useFiles } from "../../state/files";

/** Asked before a design is closed or replaced that no file has. */
export function LeavingDialog() {
  const leaving = useFiles((files) => files.leaving);
  const name = useDesign(({ state }) => state?.name || "The design");
  if (!leaving) return null;
  return (
    <Dialog
      title={`Save ${name}?`}
      onClose={() => leaving("stay")}
      actions={
        <>
          <Button onClick={() => leaving("drop")}>Do not save</Button>
          <Button onClick={() => leaving("stay")}>Cancel</Button>
          <Button kind="primary" data-first onClick={() => leaving("save")}>
            Save
          </Button>
        </>
      }
    >
      <p>It has changes that no file has. Without saving they are gone.</p>
    </Dialog>
  );
}
