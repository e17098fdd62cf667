import { Buffer } from "node:buffer";

/** A file that is wrong, and what its message has to say beside its name. */
export interface Wrong {
  readonly name: string;
  readonly contents: Buffer | string;
  readonly reason: RegExp;
}

/** A binary STL that claims so many triangles and has none. */
function stl(triangles: number): Buffer {
  const bytes = Buffer.alloc(84);
  bytes.writeUInt32LE(triangles, 80);
  return bytes;
}

const SVG = 'xmlns="http://www.w3.org/2000/svg"';

/** Files that are wrong each in its own way. `document` and `job` are good ones of this program, which are spoilt here. */
export function wrongFiles(document: string, job: string): readonly Wrong[] {
  const changed = (text: string, from: string | RegExp, to: string): string => {
    const other = text.replace(from, to);
    if (other === text) throw new Error(`${String(from)} is not in the file`);
    return other;
  };
  return [
    { name: "empty.obj", contents: "", reason: /the file is empty/ },
    { name: "empty.glb", contents: "", reason: /the file is empty/ },
    {
      name: "part.nc",
      contents: "G21\nG91\nG1 X30.6 F600\n",
      reason: /G-code can't be opened; these formats can: obj, /,
    },
    { name: "prose.obj", contents: "Once upon a time there was a wire.\n", reason: /no edges and no faces/ },
    { name: "nan.obj", contents: "v nan 0 0\nv 1 0 0\nl 1 2\n", reason: /line 1: "nan" is not a finite number/ },
    { name: "far.obj", contents: "v 1e300 0 0\nv 1 0 0\nl 1 2\n", reason: /line 1: \(1e300, 0, 0\)/ },
    { name: "index.obj", contents: "v 0 0 0\nv 1 0 0\nl 1 7\n", reason: /line 3: "7" names no vertex/ },
    { name: "points.obj", contents: "v 0 0 0\nv 1 0 0\n", reason: /no edges and no faces/ },
    {
      name: "cut.stl",
      contents: "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0",
      reason: /line 5: found "vertex 1 0"/,
    },
    { name: "claims.stl", contents: stl(100), reason: /100 triangles are announced/ },
    { name: "huge.stl", contents: stl(4_000_000_000), reason: /4000000000 triangles are announced/ },
    { name: "model.3mf", contents: "this is no archive", reason: /expected a 3MF package/ },
    { name: "header.ply", contents: "ply\nformat ascii 1.0\nend_header\n", reason: /no edges and no faces/ },
    {
      name: "cut.ply",
      contents:
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n",
      reason: /the file ends/,
    },
    {
      name: "magic.glb",
      contents: Buffer.from([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]),
      reason: /expected a glTF object/,
    },
    { name: "scene.gltf", contents: '{"asset": ', reason: /expected a glTF object/ },
    { name: "drawing.svg", contents: "<svg><path d='M0 0", reason: /line 1: found unexpected end/ },
    { name: "blank.svg", contents: `<svg ${SVG} width="10mm" height="10mm"></svg>`, reason: /no edges and no faces/ },
    {
      name: "path.svg",
      contents: `<svg ${SVG} width="10mm" height="10mm"><path d="M 0 0 L banana"/></svg>`,
      reason: /line 1: found "M 0 0 L banana"/,
    },
    { name: "part.dxf", contents: Buffer.from([0xff, 0xfe, 0, 1, 2, 3]), reason: /expected a group code/ },
    { name: "blank.dxf", contents: "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n", reason: /no edges and no faces/ },
    { name: "table.csv", contents: "name,age\nAda,36\n", reason: /expected a header with x, y and z/ },
    { name: "points.xyz", contents: "0 0 0\n1 two 0\n", reason: /line 2: "two" is not a finite number/ },
    { name: "frame.pwf", contents: "10\nbanana\n", reason: /line 1: found "10", expected v x y z, l a b/ },
    {
      name: "photo.png",
      contents: Buffer.from("89504e470d0a1a0a0000000d49484452", "hex"),
      reason: /none of the known formats|invalid Zip archive/,
    },
    { name: "notes.docx", contents: "PK\u0003\u0004", reason: /none of the known formats|invalid Zip archive/ },
    { name: "other.json", contents: '{"hello": "world"}', reason: /expected an object with node_list/ },
    { name: "prose.wirebend", contents: "Dear wire,", reason: /line 1, column 1/ },
    {
      name: "newer.wirebend",
      contents: changed(document, /"version":\s*\d+/, '"version":999'),
      reason: /version 999 is newer/,
    },
    {
      name: "spoilt.wirebend",
      contents: changed(document, /"x_mm"|"vertices"|"edges"/, '"banana"'),
      reason: /unknown field `banana`/,
    },
    {
      name: "newer.wbjob",
      contents: changed(job, /"version":\s*\d+/, '"version":999'),
      reason: /version 999 is newer/,
    },
    { name: "byte.wbjob", contents: changed(job, /(\d)(\d\.\d)/, "9$2"), reason: /hash/ },
    {
      name: "moves.wbmoves",
      contents: '{"format": "wbmoves", "version": 9, "machine": "kit", "moves": []}',
      reason: /version 9/,
    },
  ];
}
