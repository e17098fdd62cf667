import { useCallback, useEffect, useRef, useState } from "react";
import type { FormatEntry } from "../../../generated/responses";
import { Button } from "../../../shared/controls/Button";
import { Segmented } from "../../../shared/controls/inputs";
import { Dialog } from "../../../shared/layers/Dialog";
import { Line } from "../../../shared/lists/Line";
import { useDesign } from "../../../state/design/design";
import { fileBytes, write } from "../../../state/files/exports";
import { pickPlace } from "../../../state/files/files";
import { fileName } from "../groups";
import type { Zoom } from "./layout";
import { Pages } from "./Pages";
import type { PrintedPages } from "./pdf";
import "./print.css";

const message = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** The pages of what would be written, as they will be printed. */
export function PrintPreview({ format, onClose }: { readonly format: FormatEntry; readonly onClose: () => void }) {
  const name = useDesign((design) => design.state?.name ?? "");
  const [pages, setPages] = useState<PrintedPages | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const [zoom, setZoom] = useState<Zoom>("page");
  const [page, setPage] = useState(0);
  const [saving, setSaving] = useState(false);
  const [saved, setSaved] = useState<{ readonly text: string; readonly wrong: boolean } | null>(null);
  const failed = useCallback((error: unknown) => setProblem(message(error)), []);
  useEffect(() => {
    let gone = false;
    let opened: PrintedPages | null = null;
    const open = async () => {
      const [bytes, { openPages }] = await Promise.all([fileBytes(format), import("./pdf")]);
      const found = await openPages(bytes);
      if (gone) return found.close();
      opened = found;
      setPages(found);
    };
    open().catch((error: unknown) => {
      if (!gone) failed(error);
    });
    return () => {
      gone = true;
      opened?.close();
    };
  }, [format, failed]);
  const asked = useRef(false);
  const save = async () => {
    if (asked.current) return;
    asked.current = true;
    try {
      const kind = { name: format.name, extensions: [format.extension] };
      const path = await pickPlace(fileName(name, format), kind);
      if (path === null) return;
      setSaving(true);
      await write(format, path, true);
      setSaved({ text: `Written: ${path}`, wrong: false });
    } catch (error) {
      setSaved({ text: `The file was not written: ${message(error)}`, wrong: true });
    } finally {
      asked.current = false;
      setSaving(false);
    }
  };
  const count = pages?.sizes.length ?? 0;
  return (
    <Dialog
      title={`Print preview: ${format.name}`}
      onClose={onClose}
      large
      actions={
        <>
          <p className={saved?.wrong ? "print-saved wrong" : "print-saved"} role="status" title={saved?.text}>
            {saved?.text}
          </p>
          <Button
            kind="primary"
            icon="save"
            why={saving ? "The file is being written." : problem || !pages ? "There is nothing to save yet." : null}
            onClick={() => void save()}
          >
            Save…
          </Button>
        </>
      }
    >
      <div className="print-bar">
        <Segmented
          label="Zoom"
          value={zoom}
          onChoose={setZoom}
          choices={[
            { value: "page", label: "Whole page" },
            { value: "width", label: "Page width" },
            { value: "actual", label: "Actual size" },
          ]}
        />
        <p className="muted" aria-live="polite">
          {pages && !problem ? `Page ${page + 1} of ${count}` : ""}
        </p>
      </div>
      <Pages pages={problem ? null : pages} zoom={zoom} onPage={setPage} onProblem={failed}>
        {problem && (
          <ul role="alert">
            <Line tone="error" what="The pages cannot be shown" sub={problem} />
          </ul>
        )}
      </Pages>
    </Dialog>
  );
}
