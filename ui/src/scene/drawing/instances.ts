/** Many things of a kind in one draw call: a small base shape, and a row of numbers for each thing. */

import {
  type BufferGeometry,
  DynamicDrawUsage,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
} from "three";

/** Above this many rows that changed, one upload of everything is cheaper than many small ones. */
const MANY = 128;

export class Instances {
  readonly geometry = new InstancedBufferGeometry();
  private readonly stride: number;
  private rows: InstancedInterleavedBuffer;
  /** Rows changed since the last upload; null when everything goes. */
  private changed: Set<number> | null = null;

  /** `layout`: the numbers of a row, in order, by the name of the shader's attribute. */
  constructor(
    base: BufferGeometry,
    private readonly layout: readonly (readonly [name: string, size: number])[],
  ) {
    this.geometry.setIndex(base.getIndex());
    for (const [name, attribute] of Object.entries(base.attributes)) this.geometry.setAttribute(name, attribute);
    this.stride = layout.reduce((sum, [, size]) => sum + size, 0);
    this.rows = this.allocate(16);
    this.geometry.instanceCount = 0;
  }

  get count(): number {
    return this.geometry.instanceCount;
  }

  /** Rows that are new hold whatever was there: write them. */
  resize(count: number): void {
    if (count > this.rows.count) {
      const before = this.rows.array;
      // Also frees the old rows on the graphics card.
      this.geometry.dispose();
      this.rows = this.allocate(2 ** Math.ceil(Math.log2(count)));
      this.rows.array.set(before);
    }
    this.geometry.instanceCount = count;
  }

  write(row: number, ...values: number[]): void {
    this.rows.array.set(values, row * this.stride);
    this.touch(row);
  }

  /** Writes numbers of a row from its number `from` on. */
  patch(row: number, from: number, ...values: number[]): void {
    this.rows.array.set(values, row * this.stride + from);
    this.touch(row);
  }

  dispose(): void {
    this.geometry.dispose();
  }

  private touch(row: number): void {
    this.rows.needsUpdate = true;
    if (this.changed === null || this.changed.has(row)) return;
    this.changed.add(row);
    if (this.changed.size > MANY) {
      this.changed = null;
      this.rows.clearUpdateRanges();
    } else {
      this.rows.addUpdateRange(row * this.stride, this.stride);
    }
  }

  private allocate(capacity: number): InstancedInterleavedBuffer {
    const rows = new InstancedInterleavedBuffer(new Float32Array(capacity * this.stride), this.stride);
    rows.setUsage(DynamicDrawUsage);
    this.changed = null;
    rows.onUpload(() => {
      this.changed = new Set();
    });
    let offset = 0;
    for (const [name, size] of this.layout) {
      this.geometry.setAttribute(name, new InterleavedBufferAttribute(rows, size, offset));
      offset += size;
    }
    return rows;
  }
}
