/** The values of profiles that the editor shows, as they are called and grouped in it. The keys are those of docs/machines.md. */

interface Common {
  readonly key: string;
  readonly label: string;
  /** What stands in the field where nothing is known. Such a value can be taken away. */
  readonly absent?: string;
  readonly hint?: string;
}

export type FieldSpec = Common &
  (
    | { readonly kind: "length"; readonly per?: string }
    | { readonly kind: "number"; readonly unit?: string }
    | { readonly kind: "yes-no" | "sign" | "text" | "springback" | "material" }
    | { readonly kind: "choice"; readonly choices: readonly { readonly value: string; readonly label: string }[] }
  );

export interface FieldGroup {
  readonly title: string;
  readonly fields: readonly FieldSpec[];
}

const DEG = "°";

export const MACHINE_GROUPS: readonly FieldGroup[] = [
  {
    title: "Bend head",
    fields: [
      {
        key: "bend.method",
        label: "Method",
        kind: "choice",
        choices: [
          { value: "peg", label: "By a peg" },
          { value: "direct", label: "By the axis itself" },
        ],
      },
      { key: "bend.pin_radius_mm", label: "Pin radius", kind: "length", hint: "The pin that the wire wraps." },
      { key: "bend.rod_radius_mm", label: "Peg radius", kind: "length", hint: "The rod that pushes the wire." },
      { key: "bend.orbit_radius_mm", label: "Orbit R", kind: "length", hint: "From the orbit's centre to the peg's." },
      {
        key: "bend.orbit_offset_mm",
        label: "Offset s",
        kind: "length",
        hint: "From where a bend begins to the orbit's centre, along the wire.",
      },
    ],
  },
  {
    title: "Bend axis",
    fields: [
      { key: "bend.axis_limit_deg", label: "Axis limit, either way", kind: "number", unit: DEG },
      {
        key: "bend.before_zero",
        label: "Bends before zero",
        kind: "yes-no",
        absent: "no",
        hint: "The controller is told the side of a bend, so that its axis may stop before zero.",
      },
      { key: "bend.rate_deg_per_s", label: "Speed", kind: "number", unit: "°/s" },
      { key: "bend.resolution_deg", label: "Smallest step", kind: "number", unit: DEG },
      { key: "bend.torque_n_m", label: "Torque for the wire", kind: "number", unit: "N m", absent: "not known" },
    ],
  },
  {
    title: "Limits",
    fields: [
      { key: "limits.min_bend_deg", label: "Bend, negative", kind: "number", unit: DEG },
      { key: "limits.max_bend_deg", label: "Bend, positive", kind: "number", unit: DEG },
      { key: "limits.min_rotation_deg", label: "Rotation, negative", kind: "number", unit: DEG },
      { key: "limits.max_rotation_deg", label: "Rotation, positive", kind: "number", unit: DEG },
      { key: "limits.min_edge_mm", label: "Shortest edge", kind: "length" },
      { key: "limits.min_feed_mm", label: "Shortest feed", kind: "length" },
      { key: "limits.max_feed_mm", label: "Longest feed", kind: "length", absent: "no limit" },
      { key: "limits.max_stock_mm", label: "Longest stock", kind: "length", absent: "no limit" },
      { key: "limits.tail_mm", label: "Unusable tail", kind: "length" },
    ],
  },
  {
    title: "Wire that fits",
    fields: [
      { key: "wire.min_diameter_mm", label: "Thinnest", kind: "length" },
      { key: "wire.max_diameter_mm", label: "Thickest", kind: "length" },
      { key: "default_material", label: "Wire of a new design", kind: "material" },
    ],
  },
  {
    title: "Feed and head",
    fields: [
      { key: "feed.rate_mm_per_s", label: "Feed speed", kind: "length", per: "/s" },
      { key: "feed.resolution_mm", label: "Feed, smallest step", kind: "length" },
      {
        key: "feed.scale",
        label: "Feed, wire per mm",
        kind: "number",
        absent: "1",
        hint: "Wire that is fed for each commanded millimetre.",
      },
      { key: "rotate.rate_deg_per_s", label: "Rotation speed", kind: "number", unit: "°/s" },
      { key: "rotate.resolution_deg", label: "Rotation, smallest step", kind: "number", unit: DEG },
      { key: "rotate.offset_deg", label: "Rotation, offset", kind: "number", unit: DEG, absent: "0" },
      {
        key: "rotate.backlash_deg",
        label: "Rotation, backlash",
        kind: "number",
        unit: DEG,
        absent: "0",
        hint: "Motion lost when the head reverses.",
      },
    ],
  },
  {
    title: "Signs",
    fields: [
      { key: "signs.bend", label: "Bend", kind: "sign", hint: "Reversed: a positive bend is sent as a negative one." },
      { key: "signs.rotate", label: "Rotation", kind: "sign" },
    ],
  },
  {
    title: "Compensation",
    fields: [
      { key: "compensation.feed", label: "Feeds", kind: "yes-no" },
      { key: "compensation.setback", label: "Setback of the peg", kind: "yes-no" },
      { key: "compensation.springback", label: "Springback", kind: "yes-no" },
    ],
  },
  {
    title: "Time",
    fields: [
      {
        key: "time.fixed_per_bend_s",
        label: "Each bend besides its motion",
        kind: "number",
        unit: "s",
      },
      { key: "time.fixed_per_feed_s", label: "Each feed besides its motion", kind: "number", unit: "s", absent: "0" },
      { key: "time.fixed_per_turn_s", label: "Each turn besides its motion", kind: "number", unit: "s", absent: "0" },
    ],
  },
  {
    title: "Simulation",
    fields: [
      {
        key: "error",
        label: "Noise profile",
        kind: "text",
        absent: "none",
        hint: "The errors that simulations of this machine have, by the id of a noise profile.",
      },
    ],
  },
];

export const MATERIAL_GROUPS: readonly FieldGroup[] = [
  {
    title: "Bending",
    fields: [
      { key: "diameter_mm", label: "Diameter", kind: "length" },
      {
        key: "k_factor",
        label: "K-factor",
        kind: "number",
        hint: "Depth of the neutral fibre from the inner face, as a fraction of the diameter.",
      },
      {
        key: "min_bend_radius_diameters",
        label: "Smallest inner radius",
        kind: "number",
        unit: "× diameter",
        absent: "not known",
      },
      { key: "springback", label: "Springback", kind: "springback" },
    ],
  },
  {
    title: "Stiffness and strength",
    fields: [
      { key: "youngs_modulus_gpa", label: "Young's modulus E", kind: "number", unit: "GPa" },
      { key: "yield_strength_mpa", label: "Yield strength", kind: "number", unit: "MPa" },
      { key: "ultimate_strength_mpa", label: "Ultimate strength", kind: "number", unit: "MPa", absent: "not known" },
      {
        key: "fracture_strain",
        label: "Strain at fracture",
        kind: "number",
        absent: "not known",
        hint: "0.2 is 20 %.",
      },
      { key: "poisson_ratio", label: "Poisson's ratio", kind: "number", absent: "not known" },
      {
        key: "shear_modulus_gpa",
        label: "Shear modulus G",
        kind: "number",
        unit: "GPa",
        absent: "not stated",
      },
    ],
  },
  {
    title: "Mass and price",
    fields: [
      { key: "density_kg_per_m3", label: "Density", kind: "number", unit: "kg/m³" },
      { key: "price_per_mm", label: "Price", kind: "number", unit: "per mm", absent: "not known" },
      { key: "currency", label: "Currency", kind: "text", absent: "such as USD" },
      {
        key: "process_energy_mj_per_kg",
        label: "Energy to form it",
        kind: "number",
        unit: "MJ/kg",
        absent: "not known",
      },
    ],
  },
  {
    title: "What it is",
    fields: [
      { key: "alloy", label: "Alloy", kind: "text", absent: "not stated" },
      { key: "temper", label: "Temper", kind: "text", absent: "not stated" },
    ],
  },
];

/** What no form has a field of its own for. */
const OTHERS: Readonly<Record<string, string>> = {
  "calibrated.date": "Calibrated on",
  "calibrated.readings": "Calibrated from readings",
  "calibrated.machine": "Calibrated from machine",
  "calibrated.material": "Calibrated from wire",
  "springback.angle_deg": "Springback: angle",
};

/** The field of a value; none where no form has one for it alone. */
export function specOf(key: string): FieldSpec | null {
  const all = [...MACHINE_GROUPS, ...MATERIAL_GROUPS].flatMap(({ fields }) => fields);
  return all.find((field) => field.key === key) ?? null;
}

/** What a value is called, with the group that it stands in; its key where nobody gave it a name. */
export function labelOf(key: string): string {
  const other = OTHERS[key];
  if (other) return other;
  for (const { title, fields } of [...MACHINE_GROUPS, ...MATERIAL_GROUPS]) {
    const field = fields.find((one) => one.key === key || (one.kind === "springback" && key.startsWith(`${one.key}.`)));
    if (field)
      return field.key === key ? `${title}: ${field.label}` : `${field.label}: ${key.slice(field.key.length + 1)}`;
  }
  return key;
}
