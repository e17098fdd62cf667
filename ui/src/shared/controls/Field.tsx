import { type ReactNode, useId } from "react";
import "./controls.css";

/** A label beside a control, with a hint or what is wrong under it. `children` is given the ids that tie them together. */
export function Field({
  label,
  hint,
  error,
  stacked,
  children,
}: {
  readonly label: string;
  readonly hint?: ReactNode;
  readonly error?: string | null;
  /** The label above the control instead of beside it. */
  readonly stacked?: boolean;
  readonly children: (ids: {
    id: string;
    "aria-describedby": string | undefined;
    "aria-invalid": true | undefined;
  }) => ReactNode;
}) {
  const id = useId();
  const below = error ?? hint;
  return (
    <div className={stacked ? "field stacked" : "field"}>
      <label htmlFor={id}>{label}</label>
      <div className="field-control">
        {children({
          id,
          "aria-describedby": below ? `${id}-below` : undefined,
          "aria-invalid": error ? true : undefined,
        })}
        {below && (
          <p
            id={`${id}-below`}
            className={error ? "field-below wrong" : "field-below"}
            role={error ? "alert" : undefined}
          >
            {below}
          </p>
        )}
      </div>
    </div>
  );
}
