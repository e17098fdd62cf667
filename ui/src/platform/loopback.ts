import type { Requests } from "../generated/requests";
import type { Responses } from "../generated/responses";
import { type AskName, type FileKind, type Platform, Refused, type WindowEvent } from "./platform";

/**
 * The Rust side behind HTTP on this computer, for tests in a browser and for `make dev` without a display; the
 * server is not installed. The token is in the address that it prints.
 */
export class Loopback implements Platform {
  constructor(private readonly token: string) {}

  private async send(path: string, body: BodyInit | null): Promise<Response> {
    const answer = await fetch(path, { method: "POST", body, headers: { "x-token": this.token } });
    if (answer.status === 422) throw new Refused(await answer.json());
    if (!answer.ok) throw new Error(`${path}: ${answer.status} ${await answer.text()}`);
    return answer;
  }

  async ask<K extends AskName>(name: K, request: Requests[K]): Promise<Responses[K]> {
    const answer = await this.send("/ask", JSON.stringify({ ask: name, ...request }));
    return answer.json();
  }

  async stencilMesh(stencil: number): Promise<ArrayBuffer> {
    return (await this.send("/stencil", `${stencil}`)).arrayBuffer();
  }

  listen(hear: (event: WindowEvent) => void): () => void {
    const events = new EventSource(`/events?token=${encodeURIComponent(this.token)}`);
    events.onmessage = (event) => hear(JSON.parse(event.data));
    return () => events.close();
  }

  pickFile(kinds: readonly FileKind[]): Promise<string | null> {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = kinds.flatMap((kind) => kind.extensions.map((extension) => `.${extension}`)).join(",");
    return new Promise((resolve) => {
      input.onchange = () => resolve(input.files?.[0] ? this.upload(input.files[0]) : null);
      input.oncancel = () => resolve(null);
      input.click();
    });
  }

  async pickSave(suggested: string, _kind: FileKind): Promise<string | null> {
    return (await this.send(`/save-path?name=${encodeURIComponent(suggested)}`, null)).text();
  }

  /** A browser gives contents, not paths. */
  private async upload(file: File): Promise<string> {
    const name = encodeURIComponent(file.name);
    return (await this.send(`/upload?name=${name}`, await file.arrayBuffer())).text();
  }

  onDrop(hear: Parameters<Platform["onDrop"]>[0]): () => void {
    const over = (event: DragEvent) => {
      event.preventDefault();
      hear({ kind: "over" });
    };
    const left = (event: DragEvent) => {
      if (event.relatedTarget === null) hear({ kind: "left" });
    };
    const dropped = async (event: DragEvent) => {
      event.preventDefault();
      const files = [...(event.dataTransfer?.files ?? [])];
      hear({ kind: "dropped", paths: await Promise.all(files.map((file) => this.upload(file))) });
    };
    window.addEventListener("dragover", over);
    window.addEventListener("dragleave", left);
    window.addEventListener("drop", dropped);
    return () => {
      window.removeEventListener("dragover", over);
      window.removeEventListener("dragleave", left);
      window.removeEventListener("drop", dropped);
    };
  }

  onOpen(): () => void {
    return () => {};
  }

  async filesToOpen(): Promise<readonly string[]> {
    return [];
  }

  onClose(): () => void {
    return () => {};
  }

  async close(): Promise<void> {
    window.close();
  }

  setTitle(title: string): void {
    document.title = title;
  }

  async stop(): Promise<void> {
    await this.send("/stop", null);
  }
}
