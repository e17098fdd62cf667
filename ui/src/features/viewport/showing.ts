import type { DiagnosticReport } from "../../generated/responses";
import type { Touch } from "../../scene/interface";
import type { Viewport as Scene } from "../../scene/viewport";
import { lengthFormat } from "../../shared/figures/format";
import { lines } from "../../state/construction/lines";
import { useDesign } from "../../state/design/design";
import { useExact } from "../../state/design/exact";
import { useSelection } from "../../state/design/selection";
import { useFiles } from "../../state/files/files";
import { movedOf, usualScale } from "../../state/frame/figures";
import { useFrame } from "../../state/frame/frame";
import { drawnForces } from "../../state/frame/loads";
import { useShape } from "../../state/frame/shape";
import { useByHand } from "../../state/machine/by_hand";
import { useMachines } from "../../state/machine/machines";
import { coloursOf, shownDesign } from "../../state/parts/parts";
import { predictedNow, usePrediction } from "../../state/prediction/prediction";
import { touchesNow } from "../../state/program/contacts";
import { isUpToDate, usePlayback, useProgram } from "../../state/program/program";
import { useRunFile } from "../../state/program/run_file";
import { shownSequence, useSequence } from "../../state/sequence/sequence";
import { shownTheme, systemTheme } from "../../state/window/theme";
import { useUi } from "../../state/window/ui";
import { useUnits } from "../../state/window/units";
import { drawnPlane, planeOfAll, shownLines, useView } from "../../state/window/view";
import { ballsOf, playedBallsOf } from "../check/spread";
import { measureText } from "../check/texts";
import { drawnFrame } from "../frame/struts";
import { drawnSequence, layersOf } from "../sequence/struts";
import { dimensionsOf, NO_DIMENSIONS } from "./dimensions";
import { labelsOf, marksOf } from "./marks";
import { chosenOf, stencilsOf } from "./stencils";

/** Calls `apply` now and whenever what `pick` gives has changed. */
function follow<S>(
  store: { getState(): S; subscribe(hear: (state: S) => void): () => void },
  pick: (state: S) => readonly unknown[],
  apply: (state: S) => void,
): () => void {
  let before: readonly unknown[] | null = null;
  const look = (state: S) => {
    const now = pick(state);
    if (before?.every((value, index) => Object.is(value, now[index]))) return;
    before = now;
    apply(state);
  };
  look(store.getState());
  return store.subscribe(look);
}

/** Whether the view shows a wire on its machine instead of the design. */
const isShownOnMachine = (): boolean => usePlayback.getState().played !== null || useByHand.getState().played !== null;

/** Whether the view shows struts instead of the edges of the design. */
const isShownAsStruts = (): boolean => useShape.getState().view !== null || useSequence.getState().shown;

/** Keeps the view showing what the stores have, without drawing React anew; the function that is returned ends it. */
export function show(scene: Scene): () => void {
  const labels = () => {
    const design = useDesign.getState();
    const { unit } = useUnits.getState();
    const figure = (report: DiagnosticReport) => measureText(report, unit);
    scene.setLabels(
      useView.getState().annotations && !isShownOnMachine() && !isShownAsStruts()
        ? labelsOf(design.check, shownDesign(design), figure)
        : [],
    );
  };
  const dimensions = () => {
    const { dimensions: all } = useView.getState();
    scene.setDimensions(
      isShownOnMachine() || isShownAsStruts()
        ? NO_DIMENSIONS
        : dimensionsOf(useSelection.getState(), useDesign.getState(), lines(), all),
    );
  };
  // Whether a design was opened that has not been framed yet.
  let justOpened = false;
  // A user who begins to draw on nothing has chosen the view: it does not turn to the first edge.
  const drawsOnNothing = () => {
    const { vertices, surfaces } = useDesign.getState();
    if (vertices.size > 0 || surfaces.size > 0) return;
    justOpened = false;
    scene.frame();
  };
  // What the view is called as a flat drawing has wanted it; null as soon as a person has turned it.
  let flat: string | null = null;
  const showOpened = () => {
    const plane = planeOfAll(useDesign.getState());
    if (plane) {
      if (scene.face(plane)) flat = useView.getState().viewName;
    } else if (flat !== null) {
      flat = null;
      scene.view("perspective");
    }
    scene.frame();
  };
  let touched: readonly Touch[] = [];
  const touches = () => {
    const now = touchesNow();
    if (now.length + touched.length > 0) scene.setTouches(now);
    touched = now;
  };
  const building = () => {
    const sequence = useSequence.getState();
    const drawn = shownSequence(sequence);
    if (!sequence.shown || !drawn) return null;
    // Layers are those of the search: an order that is only checked is not cut anew.
    const layers = sequence.layers && sequence.found ? layersOf(sequence.found) : null;
    return drawnSequence(drawn, sequence.at, useDesign.getState(), layers);
  };
  const struts = () => {
    const { view, coloured } = useShape.getState();
    const shown = useFrame.getState().answer?.value;
    strutScale();
    if (view && shown) scene.setStruts(drawnFrame(shown, view, coloured)?.struts ?? null);
    else scene.setStruts(building());
    labels();
    dimensions();
  };
  const strutScale = () => {
    const { view, scale, swing } = useShape.getState();
    const shown = useFrame.getState().answer?.value;
    const moved = view && shown ? movedOf(shown, view) : null;
    if (moved) scene.setStrutScale((scale ?? usualScale(moved)) * swing);
  };
  const supports = () => {
    const { hold, chosen, forces, loadFile } = useFrame.getState();
    const { vertices } = useDesign.getState();
    const at = (id: number) => vertices.get(id)?.at ?? [];
    const places = hold === "chosen" ? [...chosen].map(at).filter((place) => place.length === 3) : [];
    scene.setHeld({ places, forces: drawnForces({ forces, loadFile }) });
  };
  const spread = () => {
    const prediction = predictedNow();
    scene.setSpread(prediction ? ballsOf(prediction, useDesign.getState().vertices) : []);
    playedSpread();
  };
  // Of the design's own program alone, while both are as the design is.
  const playedSpread = () => {
    const { wire } = useProgram.getState();
    const ofDesign = usePlayback.getState().played !== null && isUpToDate() && useRunFile.getState().file === null;
    const prediction = ofDesign ? predictedNow() : null;
    scene.setPlayedSpread(prediction ? playedBallsOf(prediction, wire, useDesign.getState().vertices) : []);
  };
  const chosenStencil = () => {
    const { state } = useDesign.getState();
    const { chosenStencil: chosen, stencilsShown } = useView.getState();
    scene.setChosenStencil(stencilsShown ? chosenOf(state?.stencils ?? [], chosen) : null);
  };
  const construction = () => scene.setConstruction(shownLines());
  const theme = () => scene.setTheme(shownTheme(useUi.getState().theme));
  const system = systemTheme();
  system.addEventListener("change", theme);
  const ends = [
    () => system.removeEventListener("change", theme),
    follow(
      useDesign,
      ({ vertices, edges, state }) => [vertices, edges, state?.parts],
      (design) => scene.setDesign(shownDesign(design)),
    ),
    follow(
      useDesign,
      ({ check, edges, state }) => [check, edges, state?.parts],
      (design) => scene.setMarks({ ...marksOf(design.check), colours: coloursOf(design) }),
    ),
    follow(useDesign, ({ check, vertices, state }) => [check, vertices, state?.parts], labels),
    follow(useDesign, ({ vertices, edges, state }) => [vertices, edges, state?.construction_mm], dimensions),
    follow(useSelection, (selection) => [selection.vertices, selection.edges, selection.lines], dimensions),
    follow(useView, (view) => [view.dimensions, view.measuring], dimensions),
    follow(useExact, (exact) => [exact.end, exact.side], dimensions),
    follow(
      useDesign,
      ({ state, surfaces }) => [state?.stencils, surfaces],
      ({ state, surfaces }) => scene.setStencils(stencilsOf(state?.stencils ?? [], surfaces)),
    ),
    follow(
      useSelection,
      (selection) => [selection.vertices, selection.edges, selection.lines],
      (selection) => scene.setSelection(selection),
    ),
    follow(
      useSelection,
      ({ highlight }) => [highlight],
      ({ highlight }) => scene.setHighlight(highlight),
    ),
    follow(
      useView,
      ({ tool }) => [tool],
      ({ tool }) => {
        scene.setTool(tool);
        if (tool !== "select") drawsOnNothing();
      },
    ),
    follow(
      useView,
      ({ constructing }) => [constructing],
      ({ constructing }) => scene.setDraws(constructing ? "line" : "edge"),
    ),
    follow(
      useView,
      ({ snapKinds, grid, reach }) => [snapKinds, grid, reach],
      ({ snapKinds, grid, reach }) => scene.setSnap({ kinds: snapKinds, grid, reach }),
    ),
    follow(
      useView,
      ({ tool, plane, ownPlane, planeOffset }) => [tool, plane, ownPlane, planeOffset],
      (view) => scene.setPlane(drawnPlane(view)),
    ),
    follow(
      useView,
      ({ tool, plane, ownPlane }) => [tool, plane, ownPlane],
      (view) => {
        if (view.tool === "draw") scene.face(drawnPlane(view));
      },
    ),
    follow(useDesign, ({ state }) => [state?.construction_mm], construction),
    follow(useView, (view) => [view.constructionShown], construction),
    follow(useDesign, ({ state }) => [state?.stencils], chosenStencil),
    follow(useView, (view) => [view.chosenStencil, view.stencilsShown], chosenStencil),
    follow(
      useView,
      ({ stencilsShown, stencilOpacity, stencilOffset }) => [stencilsShown, stencilOpacity, stencilOffset],
      (view) => scene.setStencilsShown(view.stencilsShown, view.stencilOpacity, view.stencilOffset),
    ),
    follow(
      useView,
      ({ preview }) => [preview],
      ({ preview }) => scene.setPreview(preview),
    ),
    follow(useView, ({ annotations }) => [annotations], labels),
    follow(
      useUnits,
      ({ unit }) => [unit],
      ({ unit }) => {
        scene.setLengths(lengthFormat(unit));
        labels();
      },
    ),
    follow(useUi, (ui) => [ui.theme], theme),
    follow(
      usePlayback,
      ({ played }) => [played],
      ({ played }) => {
        scene.play(played ?? useByHand.getState().played);
        labels();
        dimensions();
      },
    ),
    follow(
      usePlayback,
      ({ played, step, shown }) => [played, step, shown],
      ({ played, step, shown }) => {
        if (played) scene.setTime(step, shown);
      },
    ),
    follow(
      usePlayback,
      ({ played, step }) => [played, step],
      () => touches(),
    ),
    follow(
      useProgram,
      ({ basis, wire }) => [basis, wire],
      () => touches(),
    ),
    follow(
      useDesign,
      ({ collisions, version }) => [collisions, version],
      () => touches(),
    ),
    follow(
      useByHand,
      ({ played }) => [played],
      ({ played }) => {
        if (usePlayback.getState().played) return;
        scene.play(played);
        if (played) scene.setTime(played.steps.length, "designed");
        labels();
        dimensions();
      },
    ),
    follow(useFrame, ({ answer }) => [answer], struts),
    follow(useShape, ({ view, coloured }) => [view, coloured], struts),
    follow(useShape, ({ scale, swing }) => [scale, swing], strutScale),
    follow(useSequence, ({ shown, at, layers, found, changed }) => [shown, at, layers, found, changed], struts),
    follow(usePrediction, ({ answer, shown, noise, within }) => [answer, shown, noise, within], spread),
    follow(useDesign, ({ version, state }) => [version, state?.machine, state?.material], spread),
    follow(useMachines, ({ changes }) => [changes], spread),
    follow(usePlayback, ({ played }) => [played], playedSpread),
    follow(useProgram, ({ basis, wire }) => [basis, wire], playedSpread),
    follow(useFrame, ({ hold, chosen, forces, loadFile }) => [hold, chosen, forces, loadFile], supports),
    follow(useDesign, ({ vertices }) => [vertices], supports),
    follow(
      usePlayback,
      ({ played, live, step }) => [played, live, live ? step : 0],
      ({ live, step }) => scene.setProgress(live ? Math.floor(step) : null),
    ),
    useView.subscribe(({ viewName }, before) => {
      // A wire on its machine has a view of its own, and gives this one back.
      if (viewName !== before.viewName && viewName !== flat && !isShownOnMachine()) flat = null;
    }),
    useFiles.subscribe(({ opened }, before) => {
      // What is opened comes after this, in the same turn of the design's store.
      if (opened !== before.opened) justOpened = true;
    }),
    useDesign.subscribe(({ vertices, surfaces }, before) => {
      if (!justOpened || (vertices === before.vertices && surfaces === before.surfaces)) return;
      justOpened = vertices.size === 0 && surfaces.size === 0;
      if (!justOpened) showOpened();
      else if (useView.getState().tool !== "select") drawsOnNothing();
    }),
  ];
  if (useDesign.getState().vertices.size > 0) showOpened();
  return () => ends.forEach((end) => end());
}
