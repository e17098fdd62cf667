import { Field } from "../../shared/controls/Field";
import { NumberField } from "../../shared/controls/NumberField";

const MAX_PIECES = 10_000;

/** How many pieces are bent in a row, and from how much wire. */
export function Pieces({
  pieces,
  stock,
  why,
  onPieces,
  onStock,
}: {
  readonly pieces: number;
  /** Length of the wire that is loaded, mm; null where it is not known. */
  readonly stock: number | null;
  /** Why they cannot be set now. */
  readonly why: string | null;
  readonly onPieces: (pieces: number) => void;
  readonly onStock: (mm: number | null) => void;
}) {
  return (
    <div className="pieces">
      <Field label="Pieces" stacked>
        {(ids) => (
          <NumberField
            {...ids}
            kind="whole"
            label="Pieces"
            value={pieces}
            why={why}
            min={1}
            max={MAX_PIECES}
            onCommit={onPieces}
          />
        )}
      </Field>
      <Field label="Wire loaded" stacked>
        {(ids) => (
          <NumberField
            {...ids}
            label="Wire loaded"
            placeholder="not known"
            value={stock}
            why={why}
            min={0}
            onCommit={(mm) => onStock(mm > 0 ? mm : null)}
          />
        )}
      </Field>
    </div>
  );
}
