import type { WebGLRenderer } from "three";

/** More pixels than these cannot be distinguished, and cost time. */
const MAX_RATIO = 2;

/** Pixels of the screen for each CSS pixel. The window may go to another screen without changing its size. */
export class ScreenRatio {
  private ratio = 0;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly signal: AbortSignal,
    private readonly changed: () => void,
  ) {}

  /** Draws with the pixels that the screen has now, and hears when it has others. */
  follow(): void {
    const ratio = window.devicePixelRatio;
    if (ratio === this.ratio) return;
    this.ratio = ratio;
    this.renderer.setPixelRatio(Math.min(ratio, MAX_RATIO));
    const { signal } = this;
    matchMedia(`(resolution: ${ratio}dppx)`).addEventListener("change", this.changed, { once: true, signal });
  }
}
