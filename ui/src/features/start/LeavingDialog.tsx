import { Button } from "../../shared/controls/Button";
import { Dialog } from "../../shared/layers/Dialog";
import { useDesign } from "../../state/design/design";
import { useFiles } from "../../state/files/files";

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
      <p>Unsaved changes will be lost.</p>
    </Dialog>
  );
}
