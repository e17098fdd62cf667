import type { CalibrateCompareResponse } from "../../../generated/responses";
import { useUnit } from "../../../shared/figures/unit";
import { Scrolls } from "../../../shared/lists/Scrolls";
import { labelOf } from "../editor/fields";
import { shownValue } from "../editor/words";
import { KINDS, off } from "./words";

/** Two versions of a machine and its wire side by side: how far off each is for the readings of a sheet, and what differs. */
export function Compared({ compared }: { readonly compared: CalibrateCompareResponse }) {
  const unit = useUnit();
  const [before, after] = compared.machines;
  return (
    <Scrolls className="calibrate-compared" label="What changes">
      <table className="calibrate-parameters">
        <thead>
          <tr>
            <th scope="col">{compared.misfits.length > 0 ? "Off on average" : "Value"}</th>
            <th scope="col">{before}</th>
            <th scope="col">{after}</th>
          </tr>
        </thead>
        <tbody>
          {compared.misfits.map(({ kind, unit: of, misfits }) => (
            <tr key={kind}>
              <th scope="row">{KINDS[kind]}</th>
              <td>{off(misfits[0].mean_abs, of, unit)}</td>
              <td>{off(misfits[1].mean_abs, of, unit)}</td>
            </tr>
          ))}
        </tbody>
        {compared.misfits.length > 0 && (
          <thead>
            <tr>
              <th scope="col">Value</th>
              <th scope="col" />
              <th scope="col" />
            </tr>
          </thead>
        )}
        <tbody>
          {compared.values.map(({ kind, key, values }) => (
            <tr key={`${kind} ${key}`}>
              <th scope="row" title={key}>
                {labelOf(key)}
              </th>
              <td>{shownValue(key, values[0], unit)}</td>
              <td>{shownValue(key, values[1], unit)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </Scrolls>
  );
}
