import { Channel, invoke } from "@tauri-apps/api/core";
import { listen } from "@tauri-apps/api/event";
import { getCurrentWebview } from "@tauri-apps/api/webview";
import { getCurrentWindow } from "@tauri-apps/api/window";
import type { Requests } from "../generated/requests";
import type { Responses } from "../generated/responses";
import { type AskName, type FileKind, type Platform, Refused, type WindowEvent } from "./platform";

/** What a handler returns before it is there: its end is asked for later. */
function later(ending: Promise<() => void>): () => void {
  return () => void ending.then((end) => end());
}

/** The window of the installed program. */
export class TauriWindow implements Platform {
  private listening: Promise<unknown> = Promise.resolve();

  async ask<K extends AskName>(name: K, request: Requests[K]): Promise<Responses[K]> {
    try {
      return await invoke<Responses[K]>("ask", { ask: { ask: name, ...request } });
    } catch (refusal) {
      throw typeof refusal === "object" ? new Refused(refusal as Refused["refusal"]) : new Error(String(refusal));
    }
  }

  stencilMesh(stencil: number): Promise<ArrayBuffer> {
    return invoke<ArrayBuffer>("stencil_mesh", { stencil });
  }

  listen(hear: (event: WindowEvent) => void): () => void {
    const channel = new Channel<WindowEvent>();
    let hears = true;
    channel.onmessage = (event) => {
      if (hears) hear(event);
    };
    void invoke("listen", { channel });
    return () => {
      hears = false;
    };
  }

  pickFile(kinds: readonly FileKind[]): Promise<string | null> {
    return invoke("pick_file", { kinds });
  }

  pickSave(suggested: string, kind: FileKind): Promise<string | null> {
    return invoke("pick_save", { suggested, kind });
  }

  onDrop(hear: Parameters<Platform["onDrop"]>[0]): () => void {
    return later(
      getCurrentWebview().onDragDropEvent(({ payload }) => {
        if (payload.type === "drop") hear({ kind: "dropped", paths: payload.paths });
        else if (payload.type === "leave") hear({ kind: "left" });
        else hear({ kind: "over" });
      }),
    );
  }

  onOpen(hear: (path: string) => void): () => void {
    const listening = listen<string>("open-file", ({ payload }) => hear(payload));
    this.listening = listening;
    return later(listening);
  }

  async filesToOpen(): Promise<readonly string[]> {
    // The Rust side reports each file either here or by an event: it is not asked before the events are heard.
    await this.listening.catch(() => {});
    return invoke<string[]>("files_to_open");
  }

  onClose(mayClose: () => Promise<boolean>): () => void {
    return later(
      getCurrentWindow().onCloseRequested(async (event) => {
        if (!(await mayClose())) event.preventDefault();
      }),
    );
  }

  async close(): Promise<void> {
    await getCurrentWindow().destroy();
  }

  setTitle(title: string): void {
    void getCurrentWindow().setTitle(title);
  }

  async stop(): Promise<void> {
    await invoke("stop");
  }
}
