// Serves the editor to a browser with hot reload, for `make dev` without a display. Vite serves the page and forwards its requests to
// tests/loopback, the Rust side behind HTTP. Arguments: that program, and a folder for its files.
import { spawn } from "node:child_process";
import { fileURLToPath } from "node:url";
import { createServer } from "vite";

const [program, home] = process.argv.slice(2);
const root = fileURLToPath(new URL("..", import.meta.url));

// It wants a folder with a page, although vite serves the page here.
const loopback = spawn(program, ["--dist", root, "--home", home], { stdio: ["ignore", "pipe", "inherit"] });
loopback.on("error", (error) => {
  console.error(`${program}: ${error.message}`);
  process.exit(1);
});
loopback.on("exit", (code) => process.exit(code ?? 1));
process.on("exit", () => loopback.kill());
for (const signal of ["SIGINT", "SIGTERM"]) process.on(signal, () => process.exit(130));

const line = await new Promise((resolve) => loopback.stdout.once("data", (data) => resolve(data.toString().trim())));
const { origin, search } = new URL(line);
const paths = ["/ask", "/stencil", "/upload", "/save-path", "/stop", "/told"];
const proxy = Object.fromEntries(paths.map((path) => [path, origin]));
const server = await createServer({ root, server: { proxy } });
await server.listen();
const { port } = server.httpServer.address();
console.log(`open http://localhost:${port}/${search}`);
