import type { KeyboardEvent } from "react";

/** The whole program as a line to slide on. `ticks`: steps, from 0, that something is wrong with. */
export function Track({
  value,
  of,
  text,
  ticks,
  off,
  onChange,
  onKeyDown,
}: {
  readonly value: number;
  readonly of: number;
  /** Said instead of the number. */
  readonly text: string;
  readonly ticks: readonly number[];
  readonly off: boolean;
  readonly onChange: (value: number) => void;
  readonly onKeyDown: (event: KeyboardEvent) => void;
}) {
  const share = of > 0 ? value / of : 0;
  return (
    <span className="track" style={{ "--share": share } as Record<string, number>}>
      <span className="track-line" aria-hidden="true" />
      {ticks.map((step) => (
        <span
          key={step}
          className="track-tick"
          style={{ "--at": (step + 0.5) / Math.max(of, 1) } as Record<string, number>}
          title={`Step ${step + 1}: see Check`}
          aria-hidden="true"
        />
      ))}
      <input
        type="range"
        aria-label="Position in the program"
        aria-valuetext={text}
        min={0}
        max={of}
        step={0.01}
        value={value}
        disabled={off}
        onChange={(event) => onChange(Number(event.currentTarget.value))}
        onKeyDown={onKeyDown}
      />
    </span>
  );
}
