import { count } from "../../shared/figures/format";
import { useDesign } from "../../state/design/design";
import { partsOf } from "../../state/parts/parts";
import { Section } from "../panel/Section";
import { Construction } from "./Construction";
import { Stencils } from "./Stencils";
import { Wires } from "./Wires";
import "./parts.css";

const NO_LINES: readonly [] = [];

/** What the design is made of: wires that hang together, and the stencils that they are traced on. */
export function PartsSection() {
  const edges = useDesign((design) => design.edges);
  const state = useDesign((design) => design.state);
  const parts = partsOf({ edges, state });
  const stencils = state?.stencils ?? [];
  const hidden = parts.filter(({ look }) => look.hidden).length + stencils.filter(({ look }) => look.hidden).length;
  const phrase = [
    parts.length === 0 ? "no wire" : count(parts.length, "part"),
    ...(stencils.length > 0 ? [count(stencils.length, "stencil")] : []),
    ...(hidden > 0 ? [`${hidden} hidden`] : []),
  ];
  return (
    <Section id="parts" title="Parts" phrase={phrase.join(" · ")}>
      <Wires parts={parts} />
      <Construction lines={state?.construction_mm ?? NO_LINES} />
      <Stencils stencils={stencils} />
    </Section>
  );
}
