import { connect, type Socket } from "node:net";
import { join } from "node:path";

/** Where a server listens for the programs of its own computer. */
const SOCKETS = join("/tmp", ".X11-unix");

/** Requests and events of the protocol that are used here: X Window System Protocol, X Version 11. */
const CHANGE_WINDOW_ATTRIBUTES = 2;
const WARP_POINTER = 41;
const CREATE_NOTIFY = 16;
const MAP_NOTIFY = 19;
const CONFIGURE_NOTIFY = 22;
const EVENT_MASK = 0x800;
const SUBSTRUCTURE_NOTIFY = 0x80000;

/**
 * Hears from a screen which windows come up on it, at the moment when they do. A screen begins anew when the last program has left it:
 * as long as this listens, it does not.
 */
export class Windows {
  /** Width of each window in pixels. */
  private readonly widths = new Map<number, number>();
  /** Each says whether the window is the one that it waits for. */
  private waiting: ((width: number) => boolean)[] = [];
  private rest = Buffer.alloc(0);
  private root: number | null = null;

  private constructor(
    private readonly socket: Socket,
    private readonly ready: () => void,
  ) {
    socket.on("data", (bytes) => {
      this.rest = Buffer.concat([this.rest, bytes]);
      if (this.root === null) this.begin();
      if (this.root !== null) this.hear();
    });
    // Little-endian, version 11.0, and no proof of the user: it is a screen of our own.
    const hello = Buffer.alloc(12);
    hello.write("l");
    hello.writeUInt16LE(11, 2);
    socket.write(hello);
  }

  static async of(display: string): Promise<Windows> {
    const socket = connect(join(SOCKETS, `X${display.slice(1)}`));
    return new Promise((resolve, reject) => {
      socket.on("error", reject);
      const windows: Windows = new Windows(socket, () => resolve(windows));
    });
  }

  /** Resolves when a window that is at least so wide is there to be seen. */
  mapped(least: number): Promise<void> {
    return new Promise((resolve) => {
      this.waiting.push((width) => {
        if (width >= least) resolve();
        return width >= least;
      });
    });
  }

  close(): void {
    this.socket.destroy();
  }

  /** Reads what the server says of itself, and asks to hear of windows. */
  private begin(): void {
    const { rest } = this;
    if (rest.length < 8) return;
    const length = 8 + rest.readUInt16LE(6) * 4;
    if (rest.length < length) return;
    if (rest[0] !== 1) {
      this.socket.destroy(new Error("the screen refuses to be asked"));
      return;
    }
    // After 40 bytes: its maker's name, padded to 4 bytes, formats of 8 bytes each, and the screens, which begin with their root.
    const [name, formats] = [rest.readUInt16LE(24), rest[29] ?? 0];
    this.root = rest.readUInt32LE(40 + Math.ceil(name / 4) * 4 + formats * 8);
    this.rest = rest.subarray(length);
    const listen = Buffer.alloc(16);
    listen.writeUInt8(CHANGE_WINDOW_ATTRIBUTES, 0);
    listen.writeUInt16LE(4, 2);
    [this.root, EVENT_MASK, SUBSTRUCTURE_NOTIFY].forEach((value, index) => listen.writeUInt32LE(value, 4 + 4 * index));
    // The pointer into the upper left corner, where it hovers over nothing.
    const warp = Buffer.alloc(24);
    warp.writeUInt8(WARP_POINTER, 0);
    warp.writeUInt16LE(6, 2);
    warp.writeUInt32LE(this.root, 8);
    this.socket.write(Buffer.concat([listen, warp]), () => this.ready());
  }

  private hear(): void {
    for (; this.rest.length >= 32; this.rest = this.rest.subarray(32)) {
      const event = this.rest;
      const code = (event[0] ?? 0) & 0x7f;
      const window = event.readUInt32LE(8);
      if (code === CREATE_NOTIFY) this.widths.set(window, event.readUInt16LE(16));
      else if (code === CONFIGURE_NOTIFY) this.widths.set(window, event.readUInt16LE(20));
      else if (code === MAP_NOTIFY) this.waiting = this.waiting.filter((is) => !is(this.widths.get(window) ?? 0));
    }
  }
}
