import type { Vec3 } from "../../scene/interface";
import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { NumberField } from "../../shared/controls/NumberField";
import { count } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { edit } from "../../state/design/design";
import { AXES, axisIndex } from "../../state/design/geometry";
import { changeStencil, type Placement, placeStencil, type StencilView } from "../../state/parts/parts";
import { run } from "../../state/window/commands";
import { chooseStencil, useView } from "../../state/window/view";
import { PlaceFields } from "../edit/Position";
import { Part as Piece } from "../panel/Section";
import { Name } from "./Name";
import { PartRow } from "./PartRow";

type Triple = [number, number, number];

const AS_IN_FILE: Placement = { shift_mm: [0, 0, 0], turn_deg: [0, 0, 0], scale: 1 };
const SCALE = { least: 0.001, most: 1000 };

function asGiven({ placement }: StencilView): boolean {
  const { shift_mm = [0, 0, 0], turn_deg = [0, 0, 0], scale = 1 } = placement;
  return scale === 1 && [...shift_mm, ...turn_deg].every((figure) => figure === 0);
}

/** Where a stencil lies, how it is turned, and how large it is. */
function Placing({ stencil, why }: { readonly stencil: StencilView | undefined; readonly why: string | null }) {
  const { length } = useLengths();
  const surface = stencil?.surface;
  const { shift_mm = [0, 0, 0], turn_deg = [0, 0, 0], scale = 1 } = stencil?.placement ?? {};
  const middle = surface?.middle_mm ?? [0, 0, 0];
  const put = (change: (before: Placement) => Partial<Placement>) => {
    if (stencil) void placeStencil(stencil.id, change);
  };
  const at: Vec3 = [middle[0] + shift_mm[0], middle[1] + shift_mm[1], middle[2] + shift_mm[2]];
  const size = surface?.size_mm.map((mm) => length(mm * scale)).join(" × ");
  return (
    <>
      <Field label="Centre" stacked>
        {() => (
          <PlaceFields
            key={stencil?.id ?? "none"}
            at={at}
            label="Centre of the stencil"
            why={why}
            change={(_, axis, value) =>
              put(({ shift_mm: before = [0, 0, 0] }) => {
                const shifted: Triple = [...before];
                shifted[axisIndex(axis)] = value - middle[axisIndex(axis)];
                return { shift_mm: shifted };
              })
            }
          />
        )}
      </Field>
      <Field label="Rotation" hint="About X, then Y, then Z." stacked>
        {() => (
          <div className="three">
            {AXES.map((axis) => (
              <NumberField
                key={`${stencil?.id ?? "none"} ${axis}`}
                kind="angle"
                label={`Rotation of the stencil, ${axis.toUpperCase()}`}
                prefix={axis.toUpperCase()}
                value={turn_deg[axisIndex(axis)]}
                why={why}
                onCommit={(deg) =>
                  put(({ turn_deg: before = [0, 0, 0] }) => {
                    const turned: Triple = [...before];
                    turned[axisIndex(axis)] = deg;
                    return { turn_deg: turned };
                  })
                }
              />
            ))}
          </div>
        )}
      </Field>
      <Field label="Scale" hint={<span className="stencil-size">{size ?? "\u00a0"}</span>}>
        {({ id }) => (
          <NumberField
            key={stencil?.id ?? "none"}
            id={id}
            kind="percent"
            label="Scale of the stencil"
            value={scale}
            min={SCALE.least}
            max={SCALE.most}
            why={why}
            onCommit={(to) => put(() => ({ scale: to }))}
          />
        )}
      </Field>
      <div className="row">
        <Button
          why={why ?? (stencil && asGiven(stencil) ? "It lies as in its file." : null)}
          onClick={() => put(() => AS_IN_FILE)}
        >
          Reset placement
        </Button>
      </div>
    </>
  );
}

/** Surfaces to trace on: each is named, coloured, hidden, moved, turned and scaled by itself. */
export function Stencils({ stencils }: { readonly stencils: readonly StencilView[] }) {
  const id = useView((view) => view.chosenStencil);
  const chosen = stencils.find((stencil) => stencil.id === id);
  const why = !chosen
    ? "Choose a stencil in the list first."
    : chosen.surface === null
      ? "Its file was not found."
      : null;
  return (
    <Piece
      title="Stencils"
      aside={stencils.length > 0 && <span className="muted">{count(stencils.length, "stencil")}</span>}
    >
      {stencils.length === 0 && (
        <p className="muted">
          A stencil is a model to trace a wireframe on. It is for reference only and is never bent.
        </p>
      )}
      {stencils.length > 0 && (
        // biome-ignore lint/a11y/useSemanticElements: its rows are those of the list above
        <div role="list" aria-label="Stencils">
          {stencils.map((stencil) => (
            <PartRow
              key={stencil.id}
              name={stencil.name || `Stencil ${stencil.id + 1}`}
              look={stencil.look}
              usual="var(--stencil)"
              figures={stencil.surface ? count(stencil.surface.faces, "face") : "file not found"}
              chosen={stencil === chosen}
              onChoose={() => chooseStencil(stencil === chosen ? null : stencil.id)}
              onChange={(change) => void changeStencil(stencil.id, change)}
              onRemove={() => void edit({ edit: "remove-stencil", stencil: stencil.id })}
            />
          ))}
        </div>
      )}
      <div className="row">
        <Button icon="folder" onClick={() => run("open-stencil")}>
          {stencils.length === 0 ? "Open stencil…" : "Add stencil…"}
        </Button>
      </div>
      {stencils.length > 0 && (
        <>
          <Field label="Name">
            {({ id }) => (
              <Name
                key={chosen?.id ?? "none"}
                id={id}
                label="Name of the stencil"
                name={chosen?.look.name ?? ""}
                usual={chosen ? chosen.name || `Stencil ${chosen.id + 1}` : ""}
                why={chosen ? null : why}
                onCommit={(name) => chosen && void changeStencil(chosen.id, { name })}
              />
            )}
          </Field>
          <Placing stencil={chosen} why={why} />
        </>
      )}
    </Piece>
  );
}
