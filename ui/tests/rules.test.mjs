// The rules of the rooms refuse what they are for: files that break them are planted beside the same rules, and looked at.
import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, describe, expect, it } from "vitest";

const ui = fileURLToPath(new URL("..", import.meta.url));
const program = (name) => join(ui, "node_modules/.bin", name);

/** More files than these in one folder are not read any more: its listing says nothing. */
const MOST_FILES = 25;

/** Every way to write that a module knows another. */
const WAYS = [
  'import x from "PATH"; export const y = x;',
  'import type { x } from "PATH"; export type { x };',
  'export * from "PATH";',
  'export { x } from "PATH";',
  'import "PATH";',
  'export const x = () => import("PATH");',
];
const BREACHES = [
  ["src/main.tsx", "@tauri-apps/api/core", "Tauri"],
  ["src/main.tsx", "three", "three.js"],
  ...["effects", "generated/responses", "platform", "scene/interface"].map((room) => [
    "src/app/a.ts",
    `../${room}`,
    "app/",
  ]),
  ["src/app/a.ts", "@tauri-apps/api/core", "Tauri"],
  ["src/app/a.ts", "three", "three.js"],
  ...["app/App", "features/run/buttons", "shared/figures/format"].map((room) => [
    "src/effects/a.ts",
    `../${room}`,
    "effects/",
  ]),
  ["src/effects/a.ts", "../scene/viewport", "scene/"],
  ["src/effects/a.ts", "@tauri-apps/api/event", "Tauri"],
  ["src/effects/a.ts", "three/examples/jsm/a.js", "three.js"],
  ...["app/App", "effects"].map((room) => ["src/features/run/a.ts", `../../${room}`, "features/"]),
  ["src/features/run/a.ts", "../../scene/viewport", "scene/"],
  ["src/features/run/a.ts", "../../scene/bodies_view", "scene/"],
  ["src/features/run/a.ts", "@tauri-apps/api/core", "Tauri"],
  ["src/features/run/a.ts", "three", "three.js"],
  ["src/features/viewport/a.ts", "../../effects", "features/"],
  ["src/features/viewport/a.ts", "../../scene/view/camera", "viewport/"],
  ["src/features/viewport/a.ts", "@tauri-apps/api/core", "Tauri"],
  ["src/features/viewport/a.ts", "three", "three.js"],
  ["src/generated/a.ts", "../platform", "generated/"],
  ["src/generated/a.ts", "./b", "generated/"],
  ["src/generated/a.ts", "zustand", "generated/"],
  ...[
    "app/App",
    "effects",
    "features/run/buttons",
    "scene/interface",
    "shared/figures/format",
    "state/design/design",
  ].map((room) => ["src/platform/a.ts", `../${room}`, "platform/"]),
  ["src/platform/a.ts", "three", "three.js"],
  ...[
    "app/App",
    "effects",
    "features/run/buttons",
    "generated/tells",
    "platform",
    "shared/figures/format",
    "state/testing",
  ].map((room) => ["src/scene/view/a.ts", `../../${room}`, "scene/"]),
  ["src/scene/a.ts", "@tauri-apps/api/core", "Tauri"],
  ...[
    "app/App",
    "effects",
    "features/run/buttons",
    "generated/tells",
    "platform",
    "scene/interface",
    "state/testing",
  ].map((room) => ["src/shared/lists/a.ts", `../../${room}`, "shared/"]),
  ["src/shared/a.ts", "@tauri-apps/api/core", "Tauri"],
  ["src/shared/a.ts", "three", "three.js"],
  ...["app/App", "effects", "features/run/buttons", "shared/figures/format", "shared"].map((room) => [
    "src/state/design/a.ts",
    `../../${room}`,
    "state/",
  ]),
  ["src/state/design/a.ts", "../../scene/vec", "scene/"],
  ["src/state/a.ts", "@tauri-apps/api/core", "Tauri"],
  ["src/state/a.ts", "three-mesh-bvh", "three.js"],
  ["tests/a.ts", "three", "three.js"],
  ["tests/a.ts", "@tauri-apps/api/core", "Tauri"],
  ["../tests/e2e/browser/a.ts", "../../../ui/src/state/design/design", "as a person does"],
];
const ALLOWED = [
  ["src/main.tsx", "./app/Root"],
  ["src/main.tsx", "./effects"],
  ["src/app/a.ts", "../features/run/buttons"],
  ["src/app/a.ts", "../state/window/ui"],
  ["src/effects/a.ts", "../state/window/ui"],
  ["src/effects/a.ts", "../platform"],
  ["src/features/run/a.ts", "../../state/window/ui"],
  ["src/features/run/a.ts", "../../scene/interface"],
  ["src/features/run/a.ts", "../../platform"],
  ["src/features/viewport/a.ts", "../../scene/viewport"],
  ["src/features/viewport/a.ts", "../../scene/bodies_view"],
  ["src/platform/a.ts", "@tauri-apps/api/core"],
  ["src/platform/a.ts", "../generated/tells"],
  ["src/scene/view/a.ts", "../vec"],
  ["src/scene/view/a.ts", "three"],
  ["src/shared/lists/a.ts", "../controls/icons"],
  ["src/state/design/a.ts", "../../scene/interface"],
  ["src/state/design/a.ts", "../../platform"],
  ["src/state/design/a.ts", "../../generated/tells"],
  ["../tests/e2e/browser/a.ts", "../../../ui/src/generated/responses"],
];

/** What must not begin because a module is imported, however it is written. */
const EFFECTS = [
  "useX.subscribe(() => {});",
  "export const end = useX.subscribe(() => {});",
  "export const ends = [useX.subscribe(() => {})];",
  "if (isX) useX.subscribe(() => {});",
  "for (const one of all) one.subscribe(() => {});",
  "export class X {\n  static {\n    useX.subscribe(() => {});\n  }\n}",
  "export class X {\n  static end = useX.subscribe(() => {});\n}",
  "hear((told) => told);",
  'window.addEventListener("keydown", () => {});',
  'export const end = window.addEventListener("keydown", () => {});',
  "export const timer = setInterval(() => {}, 1000);",
  "export const timer = window.setTimeout(() => {}, 1000);",
  "export const frame = requestAnimationFrame(() => {});",
  'export const answer = fetch("/ask");',
  'export const events = new EventSource("/told");',
  'document.title = "WireBend-kit";',
];
const NO_EFFECTS = [
  "export const start = () => useX.subscribe(() => {});",
  "export function start() {\n  useX.subscribe(() => {});\n  return setTimeout(() => {}, 1);\n}",
  "export class X {\n  start() {\n    useX.subscribe(() => {});\n  }\n}",
  "export const useX = create(() => ({ x: 1 }));",
];

/** What must not compute how a wire bends. */
const BENDING = [
  "export const x = (rotate) => Math.sin(rotate);",
  "export const x = (bend) => Math.cos((bend * Math.PI) / 180);",
  "export const x = (a, b) => Math.atan2(a, b);",
  "export const { sin } = Math;",
  "export const x = (q, axis, bend) => q.setFromAxisAngle(axis, bend);",
  "export const x = (at, axis, bend) => at.clone().applyAxisAngle(axis, bend);",
];
const NO_BENDING = [
  "export const x = (q, other) => q.clone().multiply(other);",
  "export const x = (fed) => Math.min(fed, 1);",
];

/** What a file of its own imports, so that no finding hides another. */
const planted = [];
function plant(folder, name, text) {
  const file = join(folder, name);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, `${text}\n`);
  return file;
}
const numbered = (file, number) => join(dirname(file), `planted_${number}_${basename(file)}`);

let garden;
/** What the linter says of each planted file. */
let found;

beforeAll(() => {
  garden = mkdtempSync(join(tmpdir(), "wirebend-rules-"));
  const folder = join(garden, "ui");
  mkdirSync(folder);
  for (const name of ["biome.jsonc", "rules"]) cpSync(join(ui, name), join(folder, name), { recursive: true });
  const set = (file, path, text, says) => {
    const name = numbered(file, planted.length);
    plant(folder, name, text.replace("PATH", path));
    planted.push({ name: name.replace("../", ""), file, path, text, says });
  };
  for (const [file, path, says] of BREACHES) for (const text of WAYS) set(file, path, text, says);
  for (const [file, path] of ALLOWED) for (const text of WAYS) set(file, path, text, null);
  for (const room of ["effects", "features/run", "platform", "scene/view", "shared/lists", "state/design"]) {
    for (const text of EFFECTS) set(`src/${room}/a.ts`, "", text, "does nothing");
    for (const text of NO_EFFECTS) set(`src/${room}/a.ts`, "", text, null);
  }
  for (const room of ["scene/playback", "state/program", "state/machine"]) {
    for (const text of BENDING) set(`src/${room}/a.ts`, "", text, "from the Rust side");
    for (const text of NO_BENDING) set(`src/${room}/a.ts`, "", text, null);
  }
  for (const file of ["src/scene/view/a.ts", "src/state/design/a.ts", "src/scene/playback/a.test.ts"])
    for (const text of BENDING) set(file, "", text, null);
  set("src/state/a.ts", "../features/a", 'export type A = import("PATH").A;', "at the top of the file");
  plant(folder, "src/state/circle_a.ts", 'import { b } from "./circle_b";\nexport const a = b;');
  plant(folder, "src/state/circle_b.ts", 'import type { a } from "./circle_a";\nexport const b: typeof a = 1;');
  const { stdout } = spawnSync(
    program("biome"),
    ["lint", "--reporter=json", "--max-diagnostics=none", ".", "../tests"],
    {
      cwd: folder,
      encoding: "utf8",
      maxBuffer: 1e8,
    },
  );
  found = JSON.parse(stdout).diagnostics;
}, 60_000);
afterAll(() => rmSync(garden, { recursive: true, force: true }));

const about = ["lint/style/noRestrictedImports", "plugin"];
const said = (name) =>
  found
    .filter(({ category, location }) => about.includes(category) && location.path.endsWith(name))
    .map(({ message }) => message);

describe("what a room may not know, and what an import may not do", () => {
  it("is refused, however it is written", () => {
    const passed = planted.filter(
      ({ name, says }) => says !== null && !said(name).some((message) => message.includes(says)),
    );
    expect(passed.map(({ file, path, text }) => `${file}: ${text.replace("PATH", path)}`)).toEqual([]);
  });

  it("is all that is refused", () => {
    const refused = planted.filter(({ name, says }) => says === null && said(name).length > 0);
    expect(refused.map(({ file, path, name }) => `${file}: ${path}: ${said(name)}`)).toEqual([]);
  });

  it("has no exceptions", () => {
    const excused =
      /biome-ignore(-\w+)? (lint:|lint\/style:|lint\/suspicious:|.*(noRestrictedImports|noImportCycles|plugin))/;
    const files = readdirSync(join(ui, "src"), { recursive: true }).filter((name) => /\.tsx?$/.test(name));
    expect(files.length).toBeGreaterThan(100);
    expect(files.filter((name) => excused.test(readFileSync(join(ui, "src", name), "utf8")))).toEqual([]);
  });

  it("is written down for every room there is", () => {
    const rooms = readdirSync(join(ui, "src"), { withFileTypes: true }).filter((entry) => entry.isDirectory());
    const text = readFileSync(join(ui, "rules/rooms.jsonc"), "utf8");
    expect(rooms.map(({ name }) => name).filter((name) => !text.includes(`"**/src/${name}/**"`))).toEqual([]);
  });
});

it("modules in a circle are refused, also where only types go round", () => {
  const circles = found.filter(({ category }) => category === "lint/suspicious/noImportCycles");
  expect(circles.map(({ location }) => basename(location.path)).toSorted()).toEqual(["circle_a.ts", "circle_b.ts"]);
});

it("modules and exports that nobody uses are refused", () => {
  const folder = mkdtempSync(join(tmpdir(), "wirebend-orphans-"));
  try {
    for (const name of ["package.json", "knip.jsonc", "index.html", "vite.config.ts", "tsconfig.json"])
      cpSync(join(ui, name), join(folder, name));
    symlinkSync(join(ui, "node_modules"), join(folder, "node_modules"));
    plant(folder, "src/main.tsx", 'import { used } from "./used";\nused();');
    plant(folder, "src/used.ts", "export const used = () => {};\nexport const unused = 1;");
    plant(folder, "src/orphan.ts", "export const nobody = 1;");
    const { stdout, status } = spawnSync(program("knip"), ["--include=files,exports", "--reporter=json"], {
      cwd: folder,
      encoding: "utf8",
    });
    const { issues } = JSON.parse(stdout);
    const names = (kind) => issues.flatMap((issue) => (issue[kind] ?? []).map(({ name }) => name));
    expect(names("files")).toEqual(["src/orphan.ts"]);
    expect(names("exports")).toEqual(["unused"]);
    expect(status).not.toBe(0);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}, 60_000);

it("no selector of a style sheet has lost its block, and stands before the rule of another one", () => {
  const sheets = readdirSync(join(ui, "src"), { recursive: true }).filter((name) => name.endsWith(".css"));
  expect(sheets.length).toBeGreaterThan(10);
  expect(sheets.filter((name) => /,\s*\/\*/.test(readFileSync(join(ui, "src", name), "utf8")))).toEqual([]);
});

it(`no folder has more than ${MOST_FILES} files`, () => {
  const counts = new Map();
  for (const entry of readdirSync(join(ui, "src"), { recursive: true, withFileTypes: true }))
    if (entry.isFile()) counts.set(entry.parentPath, (counts.get(entry.parentPath) ?? 0) + 1);
  expect([...counts].filter(([, count]) => count > MOST_FILES)).toEqual([]);
});
