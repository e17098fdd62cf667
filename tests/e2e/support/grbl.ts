import { type ChildProcess, spawn } from "node:child_process";

/** Opens a terminal, says its name, and keeps it open as a cable that is plugged in; what is written to the one end is read at the other. */
const CABLE = "stty raw -echo; tty; exec sleep infinity";

/** A search for the switches, ms. */
const SEARCH_MS = 50;

/** What grbl acts on wherever it comes in a line. */
const RESET = 0x18;
const ASKS = "?".charCodeAt(0);
const HOLDS = new Set([..."!~"].map((byte) => byte.charCodeAt(0)));

/** Feed, rotation, bend: where the axes X, Y and Z are, in units of the machine. */
type Place = readonly [number, number, number];

/**
 * A bender on grbl 1.1 with switches, at a port of this computer: the answers that grbl's documentation gives to the lines of a wire and of a cut.
 * A move takes no time, a dwell takes its own. It refuses what it does not know, as grbl does. Opening the port does not start it anew.
 */
export class GrblBender {
  /** Where the feed was at each cut. */
  readonly cuts: number[] = [];
  /** Where the axes were whenever the pin went in after a bend, and the farthest that the bend axis was. */
  readonly bends: Place[] = [];
  private readonly at: [number, number, number] = [0, 0, 0];
  private farthest: number | null = null;
  private locked = true;
  private line = "";
  private readonly lines: string[] = [];
  private works = false;

  private constructor(
    private readonly cable: ChildProcess,
    readonly port: string,
  ) {
    cable.stdout?.on("data", (bytes: Buffer) => {
      for (const byte of bytes) this.hear(byte);
    });
  }

  static async start(): Promise<GrblBender> {
    const cable = spawn("script", ["--quiet", "--flush", "--command", CABLE, "/dev/null"], {
      stdio: ["pipe", "pipe", "ignore"],
    });
    const port = await new Promise<string>((resolve, reject) => {
      cable.once("error", reject);
      cable.once("exit", (code) => reject(new Error(`the terminal of the bender ended with ${code}`)));
      cable.stdout?.once("data", (bytes: Buffer) => resolve(bytes.toString().trim()));
    });
    return new GrblBender(cable, port);
  }

  async end(): Promise<void> {
    const over = new Promise((resolve) => this.cable.once("close", resolve));
    this.cable.kill();
    await over;
  }

  private say(...lines: readonly string[]): void {
    this.cable.stdin?.write(lines.map((line) => `${line}\r\n`).join(""));
  }

  private hear(byte: number): void {
    if (byte === RESET) {
      this.line = "";
      this.lines.length = 0;
      this.farthest = null;
      this.say("", "Grbl 1.1h ['$' for help]", ...(this.locked ? ["[MSG:'$H'|'$X' to unlock]"] : []));
    } else if (byte === ASKS) {
      const place = this.at.map((axis) => axis.toFixed(3)).join(",");
      this.say(`<${this.locked ? "Alarm" : "Idle"}|MPos:${place}|FS:0,0|Ov:100,100,100>`);
    } else if (byte === "\n".charCodeAt(0)) {
      this.lines.push(this.line);
      this.line = "";
      void this.work();
    } else if (byte < 0x80 && !HOLDS.has(byte)) this.line += String.fromCharCode(byte);
  }

  /** Answers one line after the other. */
  private async work(): Promise<void> {
    if (this.works) return;
    this.works = true;
    for (let line = this.lines.shift(); line !== undefined; line = this.lines.shift()) {
      const ms = line === "$H" ? SEARCH_MS : 1000 * Number(/^G4 P([\d.]+)$/.exec(line)?.[1] ?? 0);
      // Where nothing takes time, the answer comes at once.
      if (ms > 0) await new Promise((resolve) => setTimeout(resolve, ms));
      this.say(...this.answer(line));
    }
    this.works = false;
  }

  private answer(line: string): readonly string[] {
    const rates = ["$110=10000.000", "$111=10000.000", "$112=10000.000"];
    if (line === "$I") return ["[VER:1.1h.20190830:]", "[OPT:V,15,128]", "ok"];
    if (line === "$$") return ["$10=1", "$13=0", "$20=0", "$22=1", "$32=0", "$100=80.000", ...rates, "ok"];
    if (line === "$H") {
      this.locked = false;
      this.at.fill(0);
      return ["ok"];
    }
    if (line === "") return ["ok"];
    if (this.locked) return ["error:9"];
    if (line === "M8") this.cuts.push(this.at[0]);
    else if (line === "M3 S1000") this.farthest = this.at[2];
    else if (line === "M5") {
      if (this.farthest !== null) this.bends.push([this.at[0], this.at[1], this.farthest]);
      this.farthest = null;
    } else if (!/^(M9|G4 P[\d.]+)$/.test(line)) return [this.move(line)];
    return ["ok"];
  }

  /** Words of a relative move, or of what all moves rely on. */
  private move(line: string): string {
    const words = line.replace(/^\$J=/, "").split(" ");
    if (words.some((word) => !/^(G1|G21|G91|G94|F[\d.]+|[XYZ]-?[\d.]+)$/.test(word))) return "error:20";
    for (const word of words) {
      const axis = "XYZ".indexOf(word.charAt(0));
      if (axis in this.at) this.at[axis as 0 | 1 | 2] += Number(word.slice(1));
    }
    if (this.farthest !== null && Math.abs(this.at[2]) > Math.abs(this.farthest)) this.farthest = this.at[2];
    return "ok";
  }
}
