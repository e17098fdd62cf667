/** The pages of a PDF, drawn by pdf.js. It is large: this module is loaded when pages are looked at, and not before. */

import { getDocument, PDFWorker } from "pdfjs-dist/legacy/build/pdf.mjs";
import Reader from "pdfjs-dist/legacy/build/pdf.worker.min.mjs?worker";

/** Width and height of a page in mm. */
export type PageSize = readonly [number, number];

export interface PrintedPages {
  readonly sizes: readonly PageSize[];
  /** Draws a page so many pixels wide. The function that is returned gives it up. */
  draw(page: number, canvas: HTMLCanvasElement, width: number, failed: (error: unknown) => void): () => void;
  /** Ends the thread that reads the file. */
  close(): void;
}

/** Points of 1/72 inch in a millimetre. */
const POINTS = 72 / 25.4;

/** Reads a file. Its bytes are gone afterwards: they are given to the thread that reads them. */
export async function openPages(data: Uint8Array): Promise<PrintedPages> {
  const port = new Reader();
  const worker = new PDFWorker({ port } as never);
  // The fonts of what is printed are those that every system has; the file is of our own making and has neither pictures nor forms.
  const loading = getDocument({ data, worker, useWasm: false, useSystemFonts: true, verbosity: 0 });
  const close = () => {
    void loading.destroy().finally(() => {
      worker.destroy();
      port.terminate();
    });
  };
  // A thread that cannot start says so to nobody else.
  const broken = new Promise<never>((_, fail) => {
    port.onerror = () => fail(new Error("the part of the program that reads PDF files did not start"));
  });
  try {
    const file = await Promise.race([loading.promise, broken]);
    const numbers = Array.from({ length: file.numPages }, (_, index) => index + 1);
    const pages = await Promise.all(numbers.map((number) => file.getPage(number)));
    const sizes = pages.map((page): PageSize => {
      const { width, height } = page.getViewport({ scale: 1 });
      return [width / POINTS, height / POINTS];
    });
    return {
      sizes,
      draw(index, canvas, width, failed) {
        const page = pages[index];
        if (!page) return () => {};
        const viewport = page.getViewport({ scale: width / page.getViewport({ scale: 1 }).width });
        canvas.width = Math.round(viewport.width);
        canvas.height = Math.round(viewport.height);
        const task = page.render({ canvas, viewport });
        let given = false;
        task.promise.catch((error: unknown) => {
          if (!given) failed(error);
        });
        return () => {
          given = true;
          task.cancel();
        };
      },
      close,
    };
  } catch (error) {
    close();
    throw error;
  }
}
