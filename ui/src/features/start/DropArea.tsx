import { Icon } from "../../shared/controls/icons";
import { useFiles } from "../../state/files/files";
import "./start.css";

/** Shown while a file is held over the window, and while one is read. */
export function DropArea() {
  const { over, busy } = useFiles();
  return (
    <>
      {over && (
        <div className="drop-area">
          <Icon name="file" size={20} />
          Drop to open
        </div>
      )}
      <div className="reading" role="status" data-shown={busy !== null}>
        {busy && `Reading ${busy}…`}
      </div>
    </>
  );
}
