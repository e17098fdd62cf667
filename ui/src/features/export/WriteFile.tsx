import { useEffect, useRef, useState } from "react";
import type { FormatEntry } from "../../generated/responses";
import { Refused } from "../../platform";
import { Button } from "../../shared/controls/Button";
import { Either } from "../../shared/controls/Either";
import { Field } from "../../shared/controls/Field";
import { TextInput } from "../../shared/controls/inputs";
import { FileProblem, WrittenFiles } from "../../shared/lists/FileOutcome";
import { Line } from "../../shared/lists/Line";
import { isRefused, useDesign } from "../../state/design/design";
import { useExports, write } from "../../state/files/exports";
import { pickPlace } from "../../state/files/files";
import { beside, fileName, isPrinted } from "./groups";
import { PrintPreview } from "./print/PrintPreview";

/** Where the file goes, and writing it. A file that is there is replaced only when a person says so. */
export function WriteFile({ format }: { readonly format: FormatEntry }) {
  const state = useDesign((design) => design.state);
  const { written, preview, despiteErrors } = useExports();
  const suggested = beside(state?.file ?? null, fileName(state?.name ?? "", format));
  const [typed, setTyped] = useState<string | null>(null);
  /** A path that the system's dialog has asked about. */
  const [agreed, setAgreed] = useState<string | null>(null);
  const [busy, setBusy] = useState(false);
  const [previewed, setPreviewed] = useState(false);
  const [problem, setProblem] = useState<{ message: string; exists: boolean } | null>(null);
  const path = typed ?? (state?.file ? suggested : "");
  const go = async (to: string, force: boolean) => {
    setBusy(true);
    setProblem(null);
    try {
      await write(format, to, force);
    } catch (error) {
      const exists = error instanceof Refused && error.refusal.code === "exists";
      setProblem({ message: error instanceof Error ? error.message : String(error), exists });
    } finally {
      setBusy(false);
    }
  };
  const browse = async (thenWrite: boolean) => {
    const picked = await pickPlace(fileName(state?.name ?? "", format), {
      name: format.name,
      extensions: [format.extension],
    });
    if (picked === null) return;
    setTyped(picked);
    setAgreed(picked);
    setProblem(null);
    if (thenWrite) await go(picked, true);
  };
  const answered = preview?.format === format.id ? preview.refused : null;
  // What was refused before a person said that it is to be written all the same: the next preview is on its way.
  const refused = answered?.errors && despiteErrors ? null : answered;
  // What Check found of collisions is no part of the preview, which does not look for them.
  const infeasible = useDesign(isRefused);
  const withheld = format.program && infeasible && !despiteErrors ? "The machine cannot bend this: see above." : null;
  const why = busy ? "The file is being written." : refused ? refused.message : withheld;
  const done = written?.format === format.id ? written.files : [];
  const notSearched = done.length > 0 ? written?.notSearched : null;
  const answer = useRef<HTMLDivElement>(null);
  const [before] = useState(written);
  const arrived = preview?.format === format.id;
  // biome-ignore lint/correctness/useExhaustiveDependencies: a preview that arrives moves it
  useEffect(() => {
    const last = written === before ? null : answer.current?.lastElementChild;
    if (!last) return;
    // It may come beside what is seen of the panel, and a preview that arrives after it moves it down. What is seen is reported when the
    // panel has put the button back under the pointer: the answer then ends right above it, and needs no scroll but where the button is
    // at the upper edge.
    const observer = new IntersectionObserver(([seen]) => {
      observer.disconnect();
      if (seen && seen.intersectionRatio < 0.5) last.scrollIntoView({ block: "nearest" });
    });
    observer.observe(last);
    return () => observer.disconnect();
  }, [written, before, arrived]);
  return (
    <div className="stack">
      <Field label="File">
        {(ids) => (
          <span className="row">
            <TextInput
              {...ids}
              value={path}
              placeholder="choose a place"
              onChange={(event) => {
                setTyped(event.currentTarget.value);
                setProblem(null);
              }}
            />
            <Button icon="folder" aria-label="Browse" title="Browse" onClick={() => void browse(false)} />
          </span>
        )}
      </Field>
      {problem && <FileProblem problem={problem} replace={() => void go(path, true)} />}
      {/* Above the button, which stays under the pointer when the answer comes. */}
      <div ref={answer} aria-live="polite">
        <WrittenFiles files={done} />
        {notSearched && (
          <ul>
            <Line tone="warning" what={notSearched} sub="Watch the machine, with STOP at hand." />
          </ul>
        )}
      </div>
      <div className="row end">
        {isPrinted(format) && (
          <Button icon="shown" why={refused?.message ?? null} onClick={() => setPreviewed(true)}>
            Print preview…
          </Button>
        )}
        <Button kind="primary" why={why} onClick={() => void (path === "" ? browse(true) : go(path, path === agreed))}>
          {path === "" ? <Either shown="Write…" other="Write" /> : <Either shown="Write" other="Write…" />}
        </Button>
      </div>
      {previewed && <PrintPreview format={format} onClose={() => setPreviewed(false)} />}
    </div>
  );
}
