import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { App } from "./App";
import { SessionStop } from "./features/run/StopButton";
import { DialogHead } from "./shared/Dialog";
import "./shared/theme.css";
import { open } from "./state/opening";

// Before anything is drawn: what is open is asked for meanwhile.
open();
const root = document.getElementById("root");
if (!root) throw new Error("index.html has no element with the id root");
createRoot(root).render(
  <StrictMode>
    <DialogHead value={<SessionStop />}>
      <App />
    </DialogHead>
  </StrictMode>,
);
