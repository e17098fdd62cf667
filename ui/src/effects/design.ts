import { linesOf, renumberWaiting } from "../state/construction/lines";
import { lookForCollisions } from "../state/design/collisions";
import { choicesOf, forgetRefusal, useDesign } from "../state/design/design";
import { hideFix, previewGone } from "../state/design/fixes/fixes";
import { deselectLines, keepSelected, keepSelectedLines } from "../state/design/selection";
import { forgetExports, setDespiteErrors } from "../state/files/exports";
import { useFiles } from "../state/files/files";
import { forgetFrame, forgetFrameProblems, keepSupports, reloadFrameChoices } from "../state/frame/frame";
import { showFrame } from "../state/frame/shape";
import { hideByHand } from "../state/machine/by_hand";
import { stopComparing, useMachines } from "../state/machine/machines";
import { setWanted } from "../state/machine/row";
import { forgetEnded, showWire } from "../state/machine/run";
import { shownDesign } from "../state/parts/parts";
import { forgetPrediction, forgetPredictionProblem } from "../state/prediction/prediction";
import { forgetProgram, goTo, leaveStaleProgram, usePlayback } from "../state/program/program";
import { checkRunFile, forgetRunFile, useRunFile } from "../state/program/run_file";
import { forgetSequence, forgetSequenceProblem, hideSequence } from "../state/sequence/sequence";
import { designReplaced } from "../state/window/commands";
import { keepChosenStencil, setConstructionShown, useView } from "../state/window/view";
import { type End, together, whenChanged } from "./changes";

/** Another design is open, or will be in a moment: nothing that was of the one before stays. */
function followOpening(): End {
  return whenChanged(
    useFiles,
    ({ opened }) => [opened],
    () => {
      forgetRunFile();
      forgetProgram();
      // It has to be asked again then which design's wire a machine bends. The design is there after this turn.
      queueMicrotask(showWire);
      forgetEnded();
      forgetExports();
      forgetFrame();
      forgetPrediction();
      forgetSequence();
      designReplaced();
    },
  );
}

/** Another file is run, or the design again: what was shown of the one before is of the past. */
function followRunFile(): End {
  return whenChanged(
    useRunFile,
    ({ file }) => [file],
    ({ file, opened }, before) => {
      const { played, step } = usePlayback.getState();
      const anew = opened !== before.opened;
      forgetProgram();
      if (anew) forgetEnded();
      // What it leaves; it is played from its beginning. Checked anew, it is shown where it was.
      if (file && anew) void goTo(Number.POSITIVE_INFINITY);
      else if (file && played) void goTo(step);
      queueMicrotask(showWire);
    },
  );
}

/** The design is another one than a moment before: what was shown or said of it is of the past. */
function followChanges(): End {
  return together([
    whenChanged(
      useDesign,
      ({ vertices, edges, state }) => [vertices, edges, choicesOf(state)],
      () => {
        stopComparing();
        showFrame(null);
        hideSequence();
      },
    ),
    useDesign.subscribe(leaveStaleProgram),
    whenChanged(
      useDesign,
      ({ vertices, edges, state }) => [vertices, edges, choicesOf(state), JSON.stringify(state?.pauses)],
      // A machine that is armed or holds reports nothing by itself.
      showWire,
    ),
    whenChanged(useDesign, ({ vertices, edges, state, limits }) => [vertices, edges, state, limits], hideFix),
    whenChanged(useDesign, ({ limits }) => [limits], lookForCollisions),
    whenChanged(
      useDesign,
      ({ vertices, edges, state }) => [vertices, edges, state?.parts],
      // What is hidden is not selected: it would be moved or deleted unseen.
      (design) => keepSelected(shownDesign(design)),
    ),
    useDesign.subscribe(({ state }, last) => {
      const [before, after] = [linesOf(last.state), linesOf(state)];
      if (before === after) return;
      keepSelectedLines(before, after);
      renumberWaiting(before, after);
      if (after.length > before.length) setConstructionShown(true);
    }),
    whenChanged(
      useView,
      ({ constructionShown }) => [constructionShown],
      ({ constructionShown }) => {
        if (!constructionShown) deselectLines();
      },
    ),
    whenChanged(useDesign, ({ state }) => [state?.stencils], keepChosenStencil),
    whenChanged(useDesign, ({ state }) => [state?.machine], forgetExports),
    // What a person wants all the same is the design as it was.
    whenChanged(
      useDesign,
      ({ version }) => [version],
      () => setDespiteErrors(false),
    ),
    whenChanged(useDesign, ({ version }) => [version], forgetProblems),
    whenChanged(
      useDesign,
      ({ vertices, edges }) => [vertices, edges],
      () => {
        hideByHand();
        keepSupports();
      },
    ),
  ]);
}

/** Profiles have changed: what was said, shown or wanted with those before is of the past. */
function followProfiles(): End {
  return whenChanged(
    useMachines,
    ({ changes }) => [changes],
    () => {
      // Formats and settings are those of a profile.
      forgetExports();
      forgetRefusal();
      setWanted(null);
      stopComparing();
      showFrame(null);
      hideSequence();
      forgetProblems();
      showWire();
      void reloadFrameChoices();
      void checkRunFile();
    },
  );
}

/** What was in the way of an answer may be so no more. */
function forgetProblems(): void {
  forgetFrameProblems();
  forgetPredictionProblem();
  forgetSequenceProblem();
}

/** What goes with the open design. */
export function followDesign(): End {
  return together([
    followOpening(),
    followRunFile(),
    followChanges(),
    followProfiles(),
    whenChanged(
      useView,
      ({ preview }) => [preview],
      ({ preview }) => {
        if (!preview) previewGone();
      },
    ),
  ]);
}
