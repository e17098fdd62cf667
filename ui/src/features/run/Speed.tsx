import { Button } from "../../shared/controls/Button";
import { order } from "../../state/machine/run";

const STEP = 10;
const MIN = 10;
const MAX = 200;

/** How fast the wire is bent, in percent of the programmed speed: for this wire alone, the next begins with 100. */
export function Speed({ percent, why }: { readonly percent: number; readonly why: string | null }) {
  const set = (wanted: number) => void order({ order: "speed", percent: wanted });
  const slower = percent <= MIN ? "It goes no slower." : null;
  const faster = percent >= MAX ? "It goes no faster." : null;
  return (
    <fieldset className="speed" aria-label="Speed">
      <span className="muted small">Speed</span>
      <Button
        small
        aria-label="Slower"
        title="10 % slower"
        why={why ?? slower}
        onClick={() => set(Math.max(percent - STEP, MIN))}
      >
        −
      </Button>
      <output aria-label="Speed override">{percent} %</output>
      <Button
        small
        aria-label="Faster"
        title="10 % faster"
        why={why ?? faster}
        onClick={() => set(Math.min(percent + STEP, MAX))}
      >
        +
      </Button>
      <Button small why={why ?? (percent === 100 ? "It is as fast as programmed." : null)} onClick={() => set(100)}>
        100 %
      </Button>
    </fieldset>
  );
}
