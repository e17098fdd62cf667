import { useEffect, useState } from "react";
import type { BendTorqueReport, ProfileExplainResponse } from "../../../generated/responses";
import { platform } from "../../../platform";
import { TextInput } from "../../../shared/controls/inputs";
import { count, number } from "../../../shared/figures/format";
import { Dialog } from "../../../shared/layers/Dialog";
import { Scrolls } from "../../../shared/lists/Scrolls";

type Value = ProfileExplainResponse["values"][number];

/** A value on one line. */
function shown(value: unknown): string {
  if (value === null || value === undefined) return "–";
  if (Array.isArray(value))
    return value.every((one) => typeof one !== "object") ? value.join(", ") : count(value.length, "entry", "entries");
  return typeof value === "object" ? JSON.stringify(value) : String(value);
}

/** Every value of a profile with where it comes from. */
export function ExplainDialog({
  id,
  name,
  onClose,
}: {
  readonly id: string;
  readonly name: string;
  readonly onClose: () => void;
}) {
  const [profile, setProfile] = useState<ProfileExplainResponse | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const [filter, setFilter] = useState("");
  useEffect(() => {
    platform
      .ask("profile-explain", { id, kind: "machine" })
      .then(setProfile, (error: unknown) => setProblem(error instanceof Error ? error.message : String(error)));
  }, [id]);
  const wanted = filter.toLowerCase();
  const values =
    profile?.values.filter((value) =>
      `${value.key} ${shown(value.value)} ${value.source ?? ""}`.toLowerCase().includes(wanted),
    ) ?? [];
  return (
    <Dialog title={`Every value of ${name}`} onClose={onClose} wide>
      {problem && <p className="field-below wrong">{problem}</p>}
      {profile && (
        <>
          <p className="muted">
            {profile.chain.length === 1
              ? "It inherits from no other profile."
              : `It inherits from ${profile.chain
                  .slice(1)
                  .map((parent) => parent.id)
                  .join(", then ")}.`}
          </p>
          {profile.bend_torque && <Torque torque={profile.bend_torque} />}
          <TextInput
            data-first
            aria-label="Filter"
            placeholder="Filter by key, value or source"
            value={filter}
            onChange={(event) => setFilter(event.currentTarget.value)}
          />
          <Scrolls className="explain" label="Values">
            <table>
              <thead>
                <tr>
                  <th scope="col">Key</th>
                  <th scope="col">Value</th>
                  <th scope="col">Where it comes from</th>
                </tr>
              </thead>
              <tbody>
                {values.map((value) => (
                  <Row key={value.key} value={value} />
                ))}
              </tbody>
            </table>
            {values.length === 0 && <p className="muted">No value fits the filter.</p>}
          </Scrolls>
        </>
      )}
    </Dialog>
  );
}

/** What the machine can bend: its torque beside what the wires need that fit it. */
function Torque({ torque: { available_n_m, margin, wires } }: { readonly torque: BendTorqueReport }) {
  const of = wires.map(({ material, times }) => `${material} ${number(times, 1)} times`).join(", ");
  return (
    <p className="muted small">
      The bend axis has {number(available_n_m, 1)} N m. Of what a wire needs that is: {of || "no wire fits the machine"}
      . Below {number(margin, 1)} times it may stall.
    </p>
  );
}

function Row({ value }: { readonly value: Value }) {
  const line = value.line === null ? "" : `, line ${value.line}`;
  return (
    <tr className="selectable">
      <th scope="row">{value.key}</th>
      <td>{shown(value.value)}</td>
      <td>
        {value.source && (
          <div>
            {value.measured ? "Measured. " : ""}
            {value.source}
          </div>
        )}
        <div className="muted">
          {value.set_by}
          {line}
          {value.instead_of && ` · instead of ${shown(value.instead_of.value)} of ${value.instead_of.set_by}`}
        </div>
      </td>
    </tr>
  );
}
