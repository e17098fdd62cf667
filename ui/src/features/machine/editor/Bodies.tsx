import { useMemo, useState } from "react";
import type { Shape } from "../../../generated/responses";
import { Button } from "../../../shared/controls/Button";
import { Scrolls } from "../../../shared/lists/Scrolls";
import { isOwn, reportOf, SHAPES, setValue, takeBack, useProfile } from "../../../state/machine/profile";
import { bodyOf } from "../../../state/program/played";
import { BodiesPicture } from "../../viewport/BodiesPicture";
import { BodyForm } from "./BodyForm";
import { newBody, PLACED, parentOf, phraseOf, removedOf, stateOf } from "./bodies";

/** A change of one body that is not written yet: typed, or dragged. */
interface Draft {
  readonly at: number;
  readonly part: Partial<Shape>;
}

const NONE: readonly Shape[] = [];

const withDraft = (shapes: readonly Shape[], draft: Draft | null): readonly Shape[] =>
  draft ? shapes.map((shape, index) => (index === draft.at ? { ...shape, ...draft.part } : shape)) : shapes;

/**
 * The boxes and cylinders of a machine, which a wire can hit: their list, the figures of the one that is chosen, and the machine in the
 * view, where it is chosen and moved. The list is set as a whole, as profiles have it.
 */
export function Bodies({ why }: { readonly why: string | null }) {
  const view = useProfile((store) => store.view);
  const source = useProfile((store) => store.source);
  const refused = useProfile((store) => (store.refused?.key === SHAPES ? store.refused.message : null));
  const [chosen, setChosen] = useState(firstChosen);
  /** What is asked for and not written yet. */
  const [asked, setAsked] = useState<readonly Shape[] | null>(null);
  const [typed, setTyped] = useState<Draft | null>(null);
  const [dragged, setDragged] = useState<Draft | null>(null);
  const shapes = asked ?? view?.shapes ?? NONE;
  const report = reportOf(view, SHAPES);
  const own = isOwn(view, SHAPES);
  const parents = useMemo(
    () => (own ? ((report?.instead_of?.value ?? NONE) as unknown as readonly Shape[]) : shapes),
    [own, report, shapes],
  );
  const wire = view?.head?.wire_mm ?? 2;
  const orbitOffset = view?.head?.peg?.orbit_offset_mm ?? 0;
  const machine = useMemo(
    () => ({ bodies: withDraft(shapes, typed).map(bodyOf), wireDiameter: wire, orbitOffset }),
    [shapes, typed, wire, orbitOffset],
  );
  const set = (next: readonly Shape[]) => {
    setTyped(null);
    setDragged(null);
    setAsked(next);
    void setValue(SHAPES, next).finally(() => setAsked((now) => (now === next ? null : now)));
  };
  /** What is changed of a body comes from where the person says that it comes from. */
  const change = (at: number, part: Partial<Shape>) =>
    set(withDraft(shapes, { at, part: { source: source.text, measured: source.measured, ...part } }));
  const add = (solid: "box" | "cylinder") => {
    set([...shapes, newBody(solid, shapes, wire)]);
    setChosen(shapes.length);
  };
  const shown = chosen === null ? null : (withDraft(shapes, dragged)[chosen] ?? null);
  const parent = shown && parentOf(shown, parents);
  const removed = removedOf(shapes, parents);
  return (
    <div className="editor-columns bodies-columns">
      <div className="bodies-side">
        <Scrolls className="bodies-scroll" label="Bodies">
          {/* Above what it makes longer: it stays under the pointer. */}
          {!why && (
            <div className="row wrap">
              <Button small icon="plus" onClick={() => add("box")}>
                Box
              </Button>
              <Button small icon="plus" onClick={() => add("cylinder")}>
                Cylinder
              </Button>
              <span className="grow" />
              {own && removed.length > 0 && <span className="muted small">{removed.length} removed</span>}
              {own && (
                <Button kind="link" onClick={() => void takeBack(SHAPES)}>
                  Take back all bodies
                </Button>
              )}
            </div>
          )}
          <ul className="bodies">
            {shapes.map((shape, at) => {
              const state = stateOf(shape, parents);
              return (
                // biome-ignore lint/suspicious/noArrayIndexKey: two bodies may have one name, and a name changes
                <li key={at}>
                  <button
                    type="button"
                    className="body-row"
                    aria-pressed={at === chosen}
                    onClick={() => setChosen(at === chosen ? null : at)}
                  >
                    <span className={`body-swatch ${shape.part}`} aria-hidden="true" />
                    <span className="grow ellipsis">{shape.name}</span>
                    {state && <span className="value-changed">{state}</span>}
                    <span className="muted small">{phraseOf(shape)}</span>
                  </button>
                </li>
              );
            })}
          </ul>
          {shapes.length === 0 && <p className="muted">No bodies: nothing of this machine is checked for clearance.</p>}
          {refused && (
            <p className="field-below wrong" role="alert">
              {refused}
            </p>
          )}
          {shown && chosen !== null ? (
            <BodyForm
              key={chosen}
              shape={shown}
              why={why}
              onChange={(part) => change(chosen, part)}
              onType={(part) => setTyped(part && { at: chosen, part })}
              onTakeBack={
                parent && stateOf(shown, parents) === "changed"
                  ? () => set(withDraft(shapes, { at: chosen, part: restored(parent) }))
                  : null
              }
              onRemove={() => {
                set(shapes.filter((_, index) => index !== chosen));
                setChosen(null);
              }}
            />
          ) : (
            shapes.length > 0 && <p className="muted small">Choose a body here or in the view to see its figures.</p>
          )}
        </Scrolls>
      </div>
      <BodiesPicture
        machine={machine}
        chosen={chosen}
        editable={!why}
        onChoose={setChosen}
        onDrag={(at, at_mm) => setDragged({ at, part: { at_mm: [...at_mm] } })}
        onDrop={(at, at_mm) => change(at, { ...PLACED, at_mm: [...at_mm] })}
        onCancel={() => setDragged(null)}
      />
    </div>
  );
}

/** The place of the body that was asked for by its name: of several the first that is not measured. */
function firstChosen(): number | null {
  const { view, body } = useProfile.getState();
  const called = [...(view?.shapes ?? NONE).entries()].filter(([, { name }]) => name === body);
  return (called.find(([, { measured }]) => !measured) ?? called[0])?.[0] ?? null;
}

/** All of a body as the parent has it, also what the parent leaves out. */
const restored = (parent: Shape): Shape => ({
  ...parent,
  axis: parent.axis ?? [0, 0, 1],
  contact_zone_mm: parent.contact_zone_mm ?? 0,
  vertex_zone_mm: parent.vertex_zone_mm ?? 0,
});
