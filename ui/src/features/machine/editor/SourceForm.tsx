import { useState } from "react";
import { Button } from "../../../shared/controls/Button";
import { Checkbox, TextInput } from "../../../shared/controls/inputs";
import { type EnteredSource, measuredToday } from "../../../state/machine/profile";

/** Another source for a value that stays as it is. */
export function SourceForm({
  of,
  source,
  onSet,
  onDone,
}: {
  /** What it is the source of, as it is read aloud. */
  readonly of: string;
  readonly source: EnteredSource;
  readonly onSet: (source: EnteredSource) => Promise<unknown>;
  readonly onDone: () => void;
}) {
  const [text, setText] = useState(source.text);
  const [measured, setMeasured] = useState(source.measured);
  return (
    <form
      className="value-source-form inset stack"
      onSubmit={(event) => {
        event.preventDefault();
        void onSet({ text: text.trim(), measured }).then(onDone);
      }}
    >
      <TextInput
        aria-label={`Source of ${of}`}
        value={text}
        autoFocus
        onChange={(event) => setText(event.currentTarget.value)}
      />
      <div className="row wrap">
        <Checkbox checked={measured} onChange={setMeasured}>
          Measured
        </Checkbox>
        <Button
          kind="link"
          onClick={() => {
            setText(measuredToday());
            setMeasured(true);
          }}
        >
          Measured by me today
        </Button>
        <span className="grow" />
        <Button small onClick={onDone}>
          Cancel
        </Button>
        <Button small kind="primary" type="submit" why={text.trim() === "" ? "Say where the value comes from." : null}>
          Set source
        </Button>
      </div>
    </form>
  );
}
