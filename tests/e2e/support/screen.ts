import { type ChildProcess, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { PNG } from "pngjs";

/** A screen in memory, for programs that need one. */
export class Screen {
  private constructor(
    private readonly child: ChildProcess,
    readonly display: string,
    private readonly folder: string,
  ) {}

  static async open({ width = 1280, height = 800 } = {}): Promise<Screen> {
    // It takes a number that is free, and says which.
    const folder = mkdtempSync(join(tmpdir(), "wirebend-screen-"));
    const words = ["-fbdir", folder, "-displayfd", "3", "-screen", "0", `${width}x${height}x24`, "-nolisten", "tcp"];
    const child = spawn("Xvfb", words, { stdio: ["ignore", "ignore", "ignore", "pipe"] });
    const number = await new Promise<string>((resolve, reject) => {
      child.on("error", reject);
      child.on("exit", (code) => reject(new Error(`Xvfb ended with ${code}`)));
      (child.stdio[3] as NodeJS.ReadableStream).once("data", (line: Buffer) => resolve(line.toString().trim()));
    });
    return new Screen(child, `:${number}`, folder);
  }

  /** The memory of the screen, a file of the format XWD: its pixels begin at `from`, 4 bytes each. */
  pixels(): { bytes: Buffer; width: number; height: number; lineBytes: number; from: number } {
    const bytes = readFileSync(join(this.folder, "Xvfb_screen0"));
    const field = (index: number): number => bytes.readUInt32BE(index * 4);
    const [headerBytes, width, height, lineBytes, colours] = [field(0), field(4), field(5), field(12), field(19)];
    return { bytes, width, height, lineBytes, from: headerBytes + colours * 12 };
  }

  /** What is on the screen, as PNG. From its memory: the browser's own pictures never come once nothing moves on the page any more. */
  picture(): Buffer {
    const { bytes, width, height, lineBytes, from } = this.pixels();
    const png = new PNG({ width, height });
    for (let y = 0; y < height; y += 1) {
      for (let x = 0; x < width; x += 1) {
        const [pixel, to] = [from + y * lineBytes + x * 4, (y * width + x) * 4];
        png.data[to] = bytes[pixel + 2] ?? 0;
        png.data[to + 1] = bytes[pixel + 1] ?? 0;
        png.data[to + 2] = bytes[pixel] ?? 0;
        png.data[to + 3] = 255;
      }
    }
    return PNG.sync.write(png);
  }

  async close(): Promise<void> {
    if (this.child.exitCode === null) {
      const over = new Promise((resolve) => this.child.once("close", resolve));
      this.child.kill();
      await over;
    }
    rmSync(this.folder, { recursive: true, force: true });
  }
}
