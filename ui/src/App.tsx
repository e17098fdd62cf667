import { useEffect } from "react";
import "./App.css";
import { AboutDialog } from "./features/about/AboutDialog";
import { AnimateSection } from "./features/animate/AnimateSection";
import { CheckSection } from "./features/check/CheckSection";
import { EditSection } from "./features/edit/EditSection";
import { ExportSection } from "./features/export/ExportSection";
import { MachineSection } from "./features/machine/MachineSection";
import { Problems } from "./features/problems/Problems";
import { RunSection } from "./features/run/RunSection";
import { Dialogs } from "./features/start/Dialogs";
import { DropArea } from "./features/start/DropArea";
import { EmptyState } from "./features/start/EmptyState";
import { Hints } from "./features/start/Hints";
import { OpenNotes } from "./features/start/OpenNotes";
import { Unsaved } from "./features/start/Unsaved";
import { StatusBar } from "./features/statusbar/StatusBar";
import { Timeline } from "./features/timeline/Timeline";
import { Toolbar } from "./features/toolbar/Toolbar";
import { TopBar } from "./features/topbar/TopBar";
import { TraceSection } from "./features/trace/TraceSection";
import { HoverCard } from "./features/viewport/HoverCard";
import { ViewName } from "./features/viewport/ViewName";
import { Viewport } from "./features/viewport/Viewport";
import { Panel } from "./Panel";
import { open } from "./state/opening";

/** The window: bar, tools and view, panel, timeline, status. */
export function App() {
  useEffect(open, []);
  return (
    <div className="app">
      <TopBar />
      <main className="work" aria-label="Design">
        <Viewport />
        <Toolbar />
        <ViewName />
        <EmptyState />
        <Unsaved />
        <OpenNotes />
        <HoverCard />
        <Hints />
        <Problems />
      </main>
      <Panel>
        <TraceSection />
        <EditSection />
        <CheckSection />
        <AnimateSection />
        <MachineSection />
        <ExportSection />
        <RunSection />
      </Panel>
      <div className="foot">
        <Timeline />
        <StatusBar />
      </div>
      <Dialogs />
      <AboutDialog />
      <DropArea />
    </div>
  );
}
