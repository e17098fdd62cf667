import { ClosingDialog } from "./ClosingDialog";
import { ExamplesDialog } from "./ExamplesDialog";
import { KeysDialog } from "./KeysDialog";
import { LeavingDialog } from "./LeavingDialog";
import { OpeningDialog } from "./OpeningDialog";

/** What has to be answered, or is looked up, over the window. */
export function Dialogs() {
  return (
    <>
      <ExamplesDialog />
      <KeysDialog />
      <OpeningDialog />
      <LeavingDialog />
      <ClosingDialog />
    </>
  );
}
