import type { KeyboardEvent } from "react";
import { sentence } from "../../shared/figures/format";
import type { PlayedContact } from "../../state/program/contacts";
import { jump } from "../../state/program/player";
import { hitOf } from "../animate/hits";

/** What a key on the line does; of the others the window decides. */
export type Moves = Readonly<Partial<Record<string, () => void>>>;

/** What the keys of a line of steps do: on and back by one, by ten, to either end, and the space bar. */
export function movesOf(
  at: number,
  of: number,
  {
    forward,
    back,
    reset,
    goTo,
    toggle,
  }: Readonly<Record<"forward" | "back" | "reset" | "toggle", () => void>> & {
    readonly goTo: (step: number) => void;
  },
): Moves {
  return {
    ArrowRight: forward,
    ArrowUp: forward,
    ArrowLeft: back,
    ArrowDown: back,
    PageUp: () => goTo(Math.min(Math.floor(at) + 10, of)),
    PageDown: () => goTo(Math.max(Math.ceil(at) - 10, 0)),
    Home: reset,
    End: () => goTo(of),
    " ": toggle,
  };
}

/** The whole program as a line to slide on. `ticks`: steps, from 0, that something is wrong with; `contacts`: where the wire hits something. */
export function Track({
  label = "Position in the program",
  value,
  of,
  text,
  ticks,
  tickTitle = "see Check",
  contacts,
  off,
  onChange,
  moves,
}: {
  readonly label?: string;
  readonly value: number;
  readonly of: number;
  /** Said instead of the number. */
  readonly text: string;
  readonly ticks: readonly number[];
  /** Where it is said what is wrong. */
  readonly tickTitle?: string;
  readonly contacts: readonly PlayedContact[];
  readonly off: boolean;
  readonly onChange: (value: number) => void;
  readonly moves: Moves;
}) {
  const keys = (event: KeyboardEvent) => {
    const move = moves[event.key];
    if (!move || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    move();
  };
  const share = of > 0 ? value / of : 0;
  return (
    <span className="track" style={{ "--share": share } as Record<string, number>}>
      <span className="track-line" aria-hidden="true" />
      {ticks.map((step) => (
        <span
          key={step}
          className="track-tick"
          style={{ "--at": (step + 0.5) / Math.max(of, 1) } as Record<string, number>}
          title={`Step ${step + 1}: ${tickTitle}`}
          aria-hidden="true"
        />
      ))}
      <input
        type="range"
        aria-label={label}
        aria-valuetext={text}
        min={0}
        max={of}
        step={0.01}
        value={value}
        disabled={off}
        onChange={(event) => onChange(Number(event.currentTarget.value))}
        onKeyDown={keys}
      />
      {/* Above the line, where they leave it free to slide on. The list under Animate has them for the keyboard. */}
      {contacts.map((contact) => (
        <button
          key={`${contact.step} ${contact.body}`}
          type="button"
          tabIndex={-1}
          className={`track-contact ${contact.finding.severity}`}
          style={{ "--at": contact.position / Math.max(of, 1) } as Record<string, number>}
          title={`${hitOf(contact)}: ${sentence(contact.finding.message)}`}
          aria-label={`Go to ${contact.depth_mm < 0 ? "where it is near" : "the collision"}: ${hitOf(contact)}`}
          disabled={off}
          onClick={() => jump(contact.position)}
        />
      ))}
    </span>
  );
}
