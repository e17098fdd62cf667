import { StrictMode } from "react";
import { createRoot } from "react-dom/client";
import { Root } from "./app/Root";
import { open } from "./effects";
import "./shared/theme.css";

// Before anything is drawn: what is open is asked for meanwhile.
open();
const root = document.getElementById("root");
if (!root) throw new Error("index.html has no element with the id root");
createRoot(root).render(
  <StrictMode>
    <Root />
  </StrictMode>,
);
