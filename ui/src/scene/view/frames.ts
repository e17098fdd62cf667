/** Frames on demand: nothing is drawn, and no callback waits, while nothing changes. */

export class Frames {
  private pending = 0;
  private dirty = false;

  /** `work` is done before drawing, once a frame: what the pointer has brought. */
  constructor(
    private readonly work: () => void,
    private readonly draw: () => void,
  ) {}

  /** Something looks different. */
  request(): void {
    this.dirty = true;
    this.schedule();
  }

  /** Something has to be worked out, which may look different or not. */
  schedule(): void {
    if (this.pending === 0) this.pending = requestAnimationFrame(() => this.run());
  }

  /** At once: a canvas that gets another size is empty. */
  now(): void {
    this.dirty = false;
    this.draw();
  }

  dispose(): void {
    cancelAnimationFrame(this.pending);
    // Whatever is asked for later is not drawn.
    this.pending = -1;
  }

  private run(): void {
    this.pending = 0;
    this.work();
    if (this.dirty) this.now();
  }
}
