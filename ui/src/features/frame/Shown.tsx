import { Button } from "../../shared/controls/Button";
import { Either } from "../../shared/controls/Either";
import { Segmented, Slider } from "../../shared/controls/inputs";
import { movedOf, usualScale } from "../../state/frame/figures";
import { useFrame } from "../../state/frame/frame";
import {
  type Coloured,
  colourBy,
  enlarge,
  type FrameView,
  showFrame,
  toggleSwing,
  useShape,
} from "../../state/frame/shape";
import { usePlayback } from "../../state/program/program";
import { Part } from "../panel/Section";
import { COLOURED, enlarged, frequency } from "./words";

type Kind = FrameView["kind"];

const KINDS: readonly (readonly [Kind, string])[] = [
  ["loaded", "Loaded"],
  ["mode", "Mode"],
  ["made", "As made"],
  ["closed", "As closed"],
];

const WHYS: Readonly<Record<Kind, string | null>> = {
  loaded: "The frame floats, or does not stand.",
  mode: "No modes were asked for.",
  made: "Close the joints first.",
  closed: "Close the joints first.",
};

const MODES: Readonly<Record<"rigid" | "global" | "local", string>> = {
  rigid: "moves without bending",
  global: "the frame bends",
  local: "a strut bends",
};

/** What the view shows of the frame. */
export function Shown() {
  const shown = useFrame(({ answer }) => answer?.value ?? null);
  const { view, coloured, swinging } = useShape();
  const live = usePlayback((playback) => playback.live);
  if (!shown) return null;
  const viewOf = (kind: Kind): FrameView => {
    if (kind !== "mode") return { kind };
    const bends = shown.result.modes.findIndex((mode) => mode.kind !== "rigid");
    return { kind, mode: Math.max(bends, 0) };
  };
  const why = (kind: Kind): string | null => {
    if (live) return "A machine is bending the wire.";
    return movedOf(shown, viewOf(kind)) ? null : WHYS[kind];
  };
  return (
    <Part
      title="Shown"
      aside={
        <Button kind="link" why={view ? null : "The view shows the design."} onClick={() => showFrame(null)}>
          Back to the design
        </Button>
      }
    >
      <div className="stack">
        <Segmented<Kind | "design">
          label="Shown"
          value={view?.kind ?? "design"}
          choices={KINDS.map(([value, label]) => ({ value, label, why: why(value) }))}
          onChoose={(kind) => kind !== "design" && showFrame(viewOf(kind))}
        />
        <Segmented<Coloured>
          label="Coloured by"
          value={view?.kind === "loaded" ? coloured : "displacement"}
          choices={(Object.keys(COLOURED) as Coloured[]).map((value) => ({
            value,
            label: COLOURED[value],
            why: value !== "displacement" && view?.kind !== "loaded" ? "Forces are those of the loaded frame." : null,
          }))}
          onChoose={colourBy}
        />
        <Scale />
        {shown.result.modes.length > 0 && (
          <>
            <ul className="frame-modes" aria-label="Modes">
              {shown.result.modes.map(({ frequency_hz, kind, edge }, mode) => (
                // biome-ignore lint/suspicious/noArrayIndexKey: a mode is known by its place
                <li key={mode}>
                  <button
                    type="button"
                    aria-pressed={view?.kind === "mode" && view.mode === mode}
                    onClick={() => showFrame({ kind: "mode", mode })}
                  >
                    <span className="selected-first">{mode + 1}</span>
                    <span className="muted">
                      {MODES[kind]}
                      {edge !== undefined && edge !== null && `, edge ${edge}`}
                    </span>
                    <span>{frequency(frequency_hz)}</span>
                  </button>
                </li>
              ))}
            </ul>
            <div className="row">
              <span className="grow muted small">
                A mode has no size of its own, and swings more slowly than it does.
              </span>
              <Button
                icon={swinging ? "pause" : "play"}
                why={view?.kind === "mode" ? null : "Choose a mode first."}
                onClick={toggleSwing}
              >
                <Either shown={swinging ? "Hold" : "Swing"} other={swinging ? "Swing" : "Hold"} />
              </Button>
            </div>
          </>
        )}
      </div>
    </Part>
  );
}

/** Powers of ten that the slider reaches to each side of what is usual. */
const REACH = 1;

/** By how much displacements are enlarged. */
function Scale() {
  const shown = useFrame(({ answer }) => answer?.value ?? null);
  const view = useShape((shape) => shape.view);
  const scale = useShape((shape) => shape.scale);
  const moved = shown && view ? movedOf(shown, view) : null;
  const usual = moved ? usualScale(moved) : 1;
  const isMode = view?.kind === "mode";
  // A mode has no true scale: only what is seen counts.
  const low = isMode ? Math.log10(usual) - REACH : Math.min(0, Math.log10(usual) - REACH);
  const high = isMode ? Math.log10(usual) + REACH : Math.max(0, Math.log10(usual) + REACH);
  const now = scale ?? usual;
  const trueAt = (0 - low) / (high - low);
  return (
    <div className="stack">
      <div className="row">
        <span className="grow muted">Scale</span>
        <span>{!moved ? "–" : isMode ? `${Math.round((now / usual) * 100)} %` : enlarged(now)}</span>
        <Button
          small
          why={!moved ? "Nothing is shown." : isMode ? "A mode has no true scale." : null}
          onClick={() => enlarge(1)}
        >
          True scale
        </Button>
      </div>
      <div className="scale-slider" style={{ "--at": trueAt } as Record<string, number>}>
        <Slider
          label="Scale of the displacements"
          min={low}
          max={high}
          step={0.01}
          value={Math.log10(now)}
          text={enlarged(now)}
          onChange={(power) => enlarge(Math.abs(power) < 0.02 && !isMode ? 1 : 10 ** power)}
        />
        {moved && !isMode && (
          <span className={trueAt > 0.7 ? "scale-true end" : "scale-true"} aria-hidden="true">
            true
          </span>
        )}
      </div>
    </div>
  );
}
