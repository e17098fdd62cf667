import "./App.css";
import { AboutDialog } from "../features/about/AboutDialog";
import { AnimateSection } from "../features/animate/AnimateSection";
import { CheckSection } from "../features/check/CheckSection";
import { PreviewFigures } from "../features/check/PreviewFigures";
import { ContextMenu } from "../features/context/ContextMenu";
import { EditSection } from "../features/edit/EditSection";
import { ExportSection } from "../features/export/ExportSection";
import { FrameSection } from "../features/frame/FrameSection";
import { Legend } from "../features/frame/Legend";
import { ProfileEditor } from "../features/machine/editor/ProfileEditor";
import { MachineSection } from "../features/machine/MachineSection";
import { Panel } from "../features/panel/Panel";
import { PartsSection } from "../features/parts/PartsSection";
import { Problems } from "../features/problems/Problems";
import { RunSection } from "../features/run/RunSection";
import { SequenceSection } from "../features/sequence/SequenceSection";
import { Dialogs } from "../features/start/Dialogs";
import { DropArea } from "../features/start/DropArea";
import { EmptyState } from "../features/start/EmptyState";
import { Hints } from "../features/start/Hints";
import { OpenNotes } from "../features/start/OpenNotes";
import { Unsaved } from "../features/start/Unsaved";
import { StatusBar } from "../features/statusbar/StatusBar";
import { Timeline } from "../features/timeline/Timeline";
import { Toolbar } from "../features/toolbar/Toolbar";
import { TopBar } from "../features/topbar/TopBar";
import { TraceSection } from "../features/trace/TraceSection";
import { Hit } from "../features/viewport/Hit";
import { HoverCard } from "../features/viewport/HoverCard";
import { Measuring } from "../features/viewport/Measuring";
import { PlanePoints } from "../features/viewport/PlanePoints";
import { PointerHint } from "../features/viewport/PointerHint";
import { ViewCube } from "../features/viewport/ViewCube";
import { Viewport } from "../features/viewport/Viewport";
import { Guard } from "../shared/Guard";

/** The window: bar, tools and view, panel, timeline, status. Each part is guarded, so that STOP outlives a mistake in any other. */
export function App() {
  return (
    <div className="app">
      <TopBar />
      <main className="work" aria-label="Design">
        <Guard name="The view">
          <Viewport />
        </Guard>
        <Guard name="What lies over the view">
          <Toolbar />
          <ViewCube />
          <div className="view-foot">
            <div className="view-foot-rows">
              <Measuring />
              <PlanePoints />
              <OpenNotes />
              <PointerHint />
            </div>
          </div>
          <EmptyState />
          <Unsaved />
          <PreviewFigures />
          <HoverCard />
          <Hit />
          <Legend />
          <Hints />
        </Guard>
        <Problems />
      </main>
      <Panel>
        <Guard name="Trace">
          <PartsSection />
          <TraceSection />
        </Guard>
        <Guard name="Edit">
          <EditSection />
        </Guard>
        <Guard name="Check">
          <CheckSection />
        </Guard>
        <Guard name="Animate">
          <AnimateSection />
        </Guard>
        <Guard name="Frame">
          <FrameSection />
        </Guard>
        <Guard name="Sequence">
          <SequenceSection />
        </Guard>
        <Guard name="Machine">
          <MachineSection />
        </Guard>
        <Guard name="Export">
          <ExportSection />
        </Guard>
        <Guard name="Run">
          <RunSection />
        </Guard>
      </Panel>
      <div className="foot">
        <Guard name="The timeline">
          <Timeline />
        </Guard>
        <Guard name="The status bar">
          <StatusBar />
        </Guard>
      </div>
      <Guard name="The profile editor">
        <ProfileEditor />
      </Guard>
      <Guard name="A dialog">
        <Dialogs />
        <AboutDialog />
        <DropArea />
      </Guard>
      <Guard name="A menu">
        <ContextMenu />
      </Guard>
    </div>
  );
}
