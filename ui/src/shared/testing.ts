/** What tests of components need. */

import { act, type ReactNode } from "react";
import { createRoot, type Root } from "react-dom/client";
import { afterEach, beforeEach } from "vitest";

/** A place in the document for each test, which goes with it. */
export interface Place {
  readonly host: HTMLElement;
  readonly show: (what: ReactNode) => void;
}

/** Said once in a file of tests, before its own `beforeEach`. */
export function place(): Place {
  Object.assign(globalThis, { IS_REACT_ACT_ENVIRONMENT: true });
  let host: HTMLElement;
  let root: Root;
  beforeEach(() => {
    host = document.createElement("div");
    document.body.append(host);
    root = createRoot(host);
  });
  afterEach(() => {
    act(() => root.unmount());
    host.remove();
  });
  return {
    get host() {
      return host;
    },
    show: (what) => act(() => root.render(what)),
  };
}
