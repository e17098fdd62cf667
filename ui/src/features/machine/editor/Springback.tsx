import { useState } from "react";
import { Button } from "../../../shared/controls/Button";
import { Segmented } from "../../../shared/controls/inputs";
import { NumberField } from "../../../shared/controls/NumberField";
import { Scrolls } from "../../../shared/lists/Scrolls";
import { reportOf, setValue, useProfile } from "../../../state/machine/profile";

interface Pair {
  readonly angle_deg: number;
  readonly loss_deg: number;
}

interface Tables {
  readonly positive: readonly Pair[];
  readonly negative: readonly Pair[] | null;
}

const SIDES = [
  { key: "positive", label: "Positive bends" },
  { key: "negative", label: "Negative bends" },
] as const;

type Side = (typeof SIDES)[number]["key"];
/** What a table begins with. */
const FIRST: readonly number[] = [30, 120];

/** What the wire loses when it is let go: one angle, or a table of pairs. It is set as a whole, as profiles have it. */
export function Springback({ why }: { readonly why: string | null }) {
  const view = useProfile((store) => store.view);
  const source = useProfile((store) => store.source);
  /** What is asked for and not written yet. */
  const [asked, setAsked] = useState<Tables | null>(null);
  const number = reportOf(view, "springback.angle_deg")?.value as unknown;
  const pairsOf = (side: Side) =>
    (reportOf(view, `springback.${side}`)?.value ?? null) as unknown as readonly Pair[] | null;
  const { positive, negative } = asked ?? { positive: pairsOf("positive"), negative: pairsOf("negative") };
  const angle = typeof number === "number" ? number : (positive?.[0]?.loss_deg ?? 0);
  const setAngle = (value: number) =>
    void setValue("springback", {
      model: "constant",
      angle_deg: { value, source: source.text, measured: source.measured },
    });
  const setTable = (pairs: Tables) => {
    setAsked(pairs);
    void setValue("springback", {
      model: "table",
      positive: pairs.positive,
      ...(pairs.negative ? { negative: pairs.negative } : {}),
      source: source.text,
      measured: source.measured,
    }).finally(() => setAsked((now) => (now === pairs ? null : now)));
  };
  const isTable = positive !== null;
  return (
    <div className="stack">
      <div className="row wrap">
        <Segmented
          label="Springback as"
          value={isTable ? "table" : "constant"}
          choices={[
            { value: "constant", label: "One angle", why },
            { value: "table", label: "Table", why },
          ]}
          onChoose={(model) =>
            model === "constant"
              ? setAngle(angle)
              : setTable({ positive: FIRST.map((at) => ({ angle_deg: at, loss_deg: angle })), negative: null })
          }
        />
        {!isTable && (
          <span className="springback-angle">
            <NumberField
              label="Springback"
              kind="number"
              unit="°"
              min={0}
              value={typeof number === "number" ? number : null}
              why={why}
              onCommit={setAngle}
            />
          </span>
        )}
      </div>
      {isTable && (
        <div className="springback-sides">
          {SIDES.map(({ key, label }) => {
            const pairs = key === "positive" ? positive : negative;
            const set = (changed: readonly Pair[] | null) =>
              setTable({ positive, negative, [key]: changed?.toSorted((a, b) => a.angle_deg - b.angle_deg) ?? null });
            return (
              <div key={key} className="stack">
                <span className="muted">{label}</span>
                {pairs ? (
                  <Pairs
                    label={label}
                    pairs={pairs}
                    why={why}
                    onChange={set}
                    onDrop={key === "negative" ? () => set(null) : null}
                  />
                ) : (
                  <>
                    <p className="muted small">As positive bends.</p>
                    {!why && (
                      <Button small onClick={() => set(positive)}>
                        Own table
                      </Button>
                    )}
                  </>
                )}
              </div>
            );
          })}
        </div>
      )}
    </div>
  );
}

function Pairs({
  label,
  pairs,
  why,
  onChange,
  onDrop,
}: {
  readonly label: string;
  readonly pairs: readonly Pair[];
  readonly why: string | null;
  readonly onChange: (pairs: readonly Pair[]) => void;
  /** Without a table of its own; null where there must be one. */
  readonly onDrop: (() => void) | null;
}) {
  const put = (at: number, part: Partial<Pair>) =>
    onChange(pairs.map((pair, index) => (index === at ? { ...pair, ...part } : pair)));
  const last = pairs.at(-1) ?? { angle_deg: 0, loss_deg: 0 };
  return (
    <>
      <Scrolls className="pairs-table" label={label}>
        <div className="pairs-row muted small">
          <span>Finished bend</span>
          <span>Loss</span>
        </div>
        {pairs.map((pair, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: a pair has no other name
          <div key={at} className="pairs-row">
            <NumberField
              label={`${label}, bend ${at + 1}`}
              kind="number"
              unit="°"
              min={0}
              max={180}
              value={pair.angle_deg}
              why={why}
              onCommit={(value) => put(at, { angle_deg: value })}
            />
            <NumberField
              label={`${label}, loss ${at + 1}`}
              kind="number"
              unit="°"
              min={0}
              value={pair.loss_deg}
              why={why}
              onCommit={(value) => put(at, { loss_deg: value })}
            />
            <Button
              kind="quiet"
              icon="trash"
              aria-label={`Remove pair ${at + 1} of ${label.toLowerCase()}`}
              why={why ?? (pairs.length <= 2 ? "A table has two pairs at least." : null)}
              onClick={() => onChange(pairs.filter((_, index) => index !== at))}
            />
          </div>
        ))}
      </Scrolls>
      {!why && (
        <div className="row">
          <Button
            small
            icon="plus"
            onClick={() =>
              onChange([...pairs, { angle_deg: Math.min(180, last.angle_deg + 10), loss_deg: last.loss_deg }])
            }
          >
            Pair
          </Button>
          {onDrop && (
            <Button small onClick={onDrop}>
              As positive bends
            </Button>
          )}
        </div>
      )}
    </>
  );
}
