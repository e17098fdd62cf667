import { ProfileEditor } from "../machine/editor/ProfileEditor";
import { ClosingDialog } from "./ClosingDialog";
import { ExamplesDialog } from "./ExamplesDialog";
import { KeysDialog } from "./KeysDialog";
import { LeavingDialog } from "./LeavingDialog";
import { OpeningDialog } from "./OpeningDialog";

/** What has to be answered, is looked up or is entered over the window. */
export function Dialogs() {
  return (
    <>
      <ExamplesDialog />
      <KeysDialog />
      <OpeningDialog />
      <LeavingDialog />
      <ClosingDialog />
      <ProfileEditor />
    </>
  );
}
