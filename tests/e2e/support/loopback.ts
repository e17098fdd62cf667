import { type ChildProcess, spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Requests } from "../../../ui/src/generated/requests.ts";
import type { Responses } from "../../../ui/src/generated/responses.ts";
import { root } from "./places.ts";

type AskName = keyof Requests & keyof Responses;

/** The folder below `target` that it was built into: what is measured is built as what is installed. */
const BUILD = process.env.E2E_BUILD ?? "debug";

/** The window's Rust side in a home of its own. */
export class Loopback {
  private constructor(
    private readonly child: ChildProcess,
    readonly url: string,
    readonly home: string,
  ) {}

  /** Where it keeps what it is given; `start` continues with what an earlier one has left there. */
  static home(): string {
    return mkdtempSync(join(tmpdir(), "wirebend-e2e-"));
  }

  static async start(home = Loopback.home()): Promise<Loopback> {
    const program = `${root}target/${BUILD}/wirebend-loopback`;
    const child = spawn(program, ["--dist", `${root}ui/dist`, "--home", home], {
      stdio: ["ignore", "pipe", "inherit"],
    });
    const url = await new Promise<string>((resolve, reject) => {
      child.on("error", reject);
      child.on("exit", (code) => reject(new Error(`${program} ended with ${code} before it was ready`)));
      child.stdout?.once("data", (line: Buffer) => resolve(line.toString().trim()));
    });
    return new Loopback(child, url, home);
  }

  /** Asks the Rust side beside the page. */
  async ask<K extends AskName>(name: K, request: Requests[K]): Promise<Responses[K]> {
    const { origin, searchParams } = new URL(this.url);
    const headers = { "x-token": searchParams.get("token") ?? "" };
    const answer = await fetch(`${origin}/ask`, {
      method: "POST",
      headers,
      body: JSON.stringify({ ask: name, ...request }),
    });
    if (!answer.ok) throw new Error(`${name}: ${await answer.text()}`);
    return (await answer.json()) as Responses[K];
  }

  /** Ends it as a crash does: nothing is written that was not written before. */
  async kill(): Promise<void> {
    if (this.child.exitCode !== null || this.child.signalCode !== null) return;
    const over = new Promise((resolve) => this.child.once("close", resolve));
    this.child.kill("SIGKILL");
    await over;
  }

  /** Ends it and deletes its home. */
  async end(): Promise<void> {
    await this.kill();
    rmSync(this.home, { recursive: true, force: true });
  }
}
