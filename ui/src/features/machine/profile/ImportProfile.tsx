import { useState } from "react";
import { platform } from "../../../platform";
import { Button } from "../../../shared/controls/Button";
import { Field } from "../../../shared/controls/Field";
import { TextInput } from "../../../shared/controls/inputs";
import { tell, told } from "../../../state/asking/problems";
import { importedPhrase, importProfile } from "../../../state/machine/profile";
import { slugProblem } from "./slug";

export const PROFILES = { name: "Profiles", extensions: ["json"] } as const;

/** Takes a profile in that somebody has given away as a file; under another id where its own is taken. */
export function ImportProfile() {
  const [file, setFile] = useState<string | null>(null);
  const [problem, setProblem] = useState<{ text: string; taken: boolean } | null>(null);
  const [id, setId] = useState("");
  const done = () => {
    setFile(null);
    setProblem(null);
    setId("");
  };
  const take = async (path: string, as: string | null) => {
    const found = await importProfile(path, as);
    if ("name" in found) {
      tell("info", importedPhrase(found), "import-profile");
      done();
    } else setProblem({ text: found.problem, taken: found.taken });
  };
  const pick = async () => {
    done();
    const picked = await told(platform.pickFile([PROFILES]));
    if (!picked) return;
    setFile(picked);
    await take(picked, null);
  };
  return (
    <div className="stack">
      <div className="row">
        <Button icon="folder" onClick={() => void pick()}>
          Import a profile…
        </Button>
      </div>
      {problem && file && (
        <form
          className="inset stack"
          onSubmit={(event) => {
            event.preventDefault();
            void take(file, id);
          }}
        >
          <p role="alert" className="field-below wrong">
            {problem.text}
          </p>
          {problem.taken && (
            <Field label="Other id">
              {(ids) => (
                <TextInput {...ids} value={id} autoFocus onChange={(event) => setId(event.currentTarget.value)} />
              )}
            </Field>
          )}
          <div className="row end">
            <Button onClick={done}>Close</Button>
            {problem.taken && (
              <Button kind="primary" type="submit" why={slugProblem(id, [])}>
                Import
              </Button>
            )}
          </div>
        </form>
      )}
    </div>
  );
}
