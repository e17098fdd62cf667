import { afterAll, beforeAll } from "vitest";
import { discard, type Unpacked, unpack } from "./installed.ts";
import { Screen } from "./screen.ts";

/** The package and a screen to use it on, for the tests of a file. */
export interface Seat {
  readonly unpacked: Unpacked;
  readonly screen: Screen;
}

/** Said once in a file of tests. */
export function seat(): Seat {
  let unpacked: Unpacked;
  let screen: Screen;
  beforeAll(async () => {
    unpacked = unpack();
    screen = await Screen.open({ width: 1440, height: 900 });
  });
  afterAll(async () => {
    await screen.close();
    discard(unpacked);
  });
  return {
    get unpacked() {
      return unpacked;
    },
    get screen() {
      return screen;
    },
  };
}
