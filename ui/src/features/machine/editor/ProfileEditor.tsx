import { type FocusEvent, useState } from "react";
import { platform } from "../../../platform";
import { Button } from "../../../shared/controls/Button";
import { Checkbox, Segmented, TextInput } from "../../../shared/controls/inputs";
import { Dialog } from "../../../shared/layers/Dialog";
import { Mark } from "../../../shared/lists/Mark";
import { Scrolls } from "../../../shared/lists/Scrolls";
import { told } from "../../../state/asking/problems";
import { useKnown } from "../../../state/design/collisions";
import { useDesign } from "../../../state/design/design";
import {
  closeProfile,
  enterSource,
  isOwn,
  LAST_CHANGE,
  openProfile,
  SHAPES,
  showPart,
  takeBackLast,
  useProfile,
} from "../../../state/machine/profile";
import { phraseOf } from "../../check/texts";
import { CopyProfile } from "../profile/CopyProfile";
import { PROFILES } from "../profile/ImportProfile";
import { Bodies } from "./Bodies";
import { MACHINE_GROUPS, MATERIAL_GROUPS } from "./fields";
import { HeadPicture } from "./HeadPicture";
import { ValueRow } from "./ValueRow";
import "./editor.css";

/** The editor of the profile that is open: its values as forms, each with its source, and the head of a machine to scale. */
export function ProfileEditor() {
  const { open, part, body, view, problem, typedHead } = useProfile();
  const [active, setActive] = useState<string | null>(null);
  const [only, setOnly] = useState<"all" | "changed">("all");
  const [copying, setCopying] = useState(false);
  if (!open) return null;
  const { kind, id } = open;
  const groups = kind === "machine" ? MACHINE_GROUPS : MATERIAL_GROUPS;
  const name = view?.profile.name ?? id;
  const why = view?.shipped === false ? null : "This profile comes with the program. Copy it first.";
  const keys = groups.flatMap(({ fields }) => fields.map(({ key }) => key));
  const shapes = view?.shapes.length ?? 0;
  const bodies = kind === "machine" && part === "bodies";
  const changed = keys.filter((key) => isOwn(view, key)).length;
  const parent = view?.profile.chain[1];
  const close = () => {
    setCopying(false);
    setOnly("all");
    closeProfile();
  };
  const focused = (event: FocusEvent) =>
    setActive(event.target.closest<HTMLElement>("[data-key]")?.dataset.key ?? null);
  return (
    <Dialog
      title={`${kind === "machine" ? "Machine" : "Wire"}: ${name}`}
      onClose={close}
      large
      actions={<Foot onClose={close} />}
    >
      {problem && <p className="field-below wrong">{problem}</p>}
      {view && (
        <>
          <div className="editor-head">
            {kind === "machine" && (
              <Segmented
                label="Part of the profile"
                value={part}
                choices={[
                  { value: "values", label: "Values" },
                  { value: "bodies", label: `Bodies (${shapes})${isOwn(view, SHAPES) ? ", changed" : ""}` },
                ]}
                onChoose={showPart}
              />
            )}
            {view.shipped ? (
              <>
                <p className="grow">
                  This profile comes with the program and stays as it is. Copy it to enter what you have measured.
                </p>
                <Button kind="primary" icon="copy" aria-expanded={copying} onClick={() => setCopying(!copying)}>
                  Copy to my profiles…
                </Button>
              </>
            ) : (
              <>
                <p className="grow muted ellipsis">
                  {parent
                    ? `Inherits from ${parent.id}: what you do not change stays as it is there.`
                    : "Inherits from no other profile."}
                </p>
                {!bodies && (
                  <Segmented
                    label="Values"
                    value={only}
                    choices={[
                      { value: "all", label: "All" },
                      { value: "changed", label: `Changed (${changed})` },
                    ]}
                    onChoose={setOnly}
                  />
                )}
              </>
            )}
          </div>
          {copying && view.shipped && (
            <CopyProfile
              kind={kind}
              from={id}
              fromName={name}
              onDone={(made) => {
                setCopying(false);
                if (made) void openProfile(kind, made, part, body);
              }}
            />
          )}
          {bodies ? (
            <>
              <Bodies key={id} why={why} />
              {!view.shipped && <Source inline />}
            </>
          ) : (
            <div className={kind === "machine" ? "editor-columns" : "editor-columns one"}>
              <Scrolls className="editor-values" label="Values">
                {/* biome-ignore lint/a11y/noStaticElementInteractions: it only looks which of its fields is in use */}
                <div onFocus={focused} onBlur={() => setActive(null)}>
                  {groups.map(({ title, fields }) => {
                    const shown = fields.filter(({ key }) => only === "all" || isOwn(view, key));
                    return shown.length === 0 ? null : (
                      <fieldset key={title} className="value-group">
                        <legend>{title}</legend>
                        {shown.map((spec) => (
                          <ValueRow key={`${id} ${spec.key}`} spec={spec} why={why} />
                        ))}
                      </fieldset>
                    );
                  })}
                  {only === "changed" && changed === 0 && (
                    <p className="muted">Nothing is changed against {parent?.id}.</p>
                  )}
                </div>
              </Scrolls>
              <aside className="editor-side" aria-label="Drawing and source">
                {kind === "machine" && <HeadPicture head={typedHead ?? view.head ?? null} active={active} />}
                {!view.shipped && <Source />}
              </aside>
            </div>
          )}
        </>
      )}
    </Dialog>
  );
}

/** The source that the values take which are entered from now on. */
function Source({ inline = false }: { readonly inline?: boolean }) {
  const source = useProfile((store) => store.source);
  return (
    <fieldset className={inline ? "editor-source inline" : "editor-source stack"}>
      <legend className={inline ? "visually-hidden" : undefined}>Source of what you enter</legend>
      {inline && <span aria-hidden="true">Source of what you enter</span>}
      <TextInput
        aria-label="Source of what you enter"
        value={source.text}
        aria-invalid={source.text.trim() === "" || undefined}
        onChange={(event) => enterSource({ ...source, text: event.currentTarget.value })}
      />
      <Checkbox checked={source.measured} onChange={(measured) => enterSource({ ...source, measured })}>
        Measured on the machine or the wire
      </Checkbox>
      {!inline && (
        <p className="muted small">Every value that you change takes it. A calibration trusts measured values more.</p>
      )}
    </fieldset>
  );
}

/** What the design is with the values as they are, and what is done with the profile as a whole. */
function Foot({ onClose }: { readonly onClose: () => void }) {
  const { open, view, busy } = useProfile();
  const refused = useProfile((store) => (store.refused?.key === LAST_CHANGE ? store.refused.message : null));
  const { check, state, vertices } = useDesign();
  const { phrase, tone } = phraseOf(check, Boolean(state?.machine), vertices.size === 0, useKnown());
  if (!open) return null;
  const used = open.id === (open.kind === "machine" ? state?.machine : state?.material);
  const save = async () => {
    const path = await told(platform.pickSave(`${open.id}.json`, PROFILES));
    if (!path) return;
    await told(platform.ask("export-profile", { kind: open.kind, id: open.id, output: { path, force: true } }));
  };
  return (
    <>
      <p className="editor-check grow" aria-live="polite">
        {refused ? (
          <span className="value-refused">{refused}</span>
        ) : used ? (
          <>
            {tone && <Mark tone={tone} />}
            <span>Open design: {phrase}</span>
          </>
        ) : (
          <span className="muted">The open design has another {open.kind === "machine" ? "machine" : "wire"}.</span>
        )}
      </p>
      <Button
        icon="undo"
        why={
          !view || view.shipped
            ? "This profile comes with the program."
            : !view.has_last_change
              ? "This program has not changed it since it was made."
              : busy
                ? "The file is being written."
                : null
        }
        title="Once more makes the change again"
        onClick={() => void takeBackLast()}
      >
        Undo the last change
      </Button>
      <Button icon="save" why={view ? null : "It is being read."} onClick={() => void save()}>
        Export…
      </Button>
      <Button kind="primary" onClick={onClose}>
        Done
      </Button>
    </>
  );
}
