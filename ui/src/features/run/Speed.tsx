import { useRef } from "react";
import { Button } from "../../shared/controls/Button";
import { order } from "../../state/machine/run";

const STEP = 10;
const MIN = 10;
const MAX = 200;
/** So long a machine may take to report the speed that it was asked for, ms. */
const ON_ITS_WAY = 2000;

/** How fast the wire is bent, in percent of the programmed speed: for this wire alone, the next begins with 100. */
export function Speed({ percent, why }: { readonly percent: number; readonly why: string | null }) {
  const last = useRef({ percent, at: Number.NEGATIVE_INFINITY });
  const set = (wanted: number) => {
    last.current = { percent: wanted, at: performance.now() };
    void order({ order: "speed", percent: wanted }).then((taken) => {
      if (!taken) last.current.at = Number.NEGATIVE_INFINITY;
    });
  };
  // A second click is a second step, also before the machine has reported the first.
  const step = (by: number) => {
    const from = performance.now() - last.current.at < ON_ITS_WAY ? last.current.percent : percent;
    set(Math.min(Math.max(from + by, MIN), MAX));
  };
  const slower = percent <= MIN ? "It goes no slower." : null;
  const faster = percent >= MAX ? "It goes no faster." : null;
  return (
    <fieldset className="speed" aria-label="Speed">
      <span className="muted small">Speed</span>
      <Button small aria-label="Slower" title="10 % slower" why={why ?? slower} onClick={() => step(-STEP)}>
        −
      </Button>
      <output aria-label="Speed override">{percent} %</output>
      <Button small aria-label="Faster" title="10 % faster" why={why ?? faster} onClick={() => step(STEP)}>
        +
      </Button>
      <Button small why={why ?? (percent === 100 ? "It is as fast as programmed." : null)} onClick={() => set(100)}>
        100 %
      </Button>
    </fieldset>
  );
}
