import { Button } from "../../shared/controls/Button";
import { openBodies } from "../../state/machine/profile";

/** Opens the bodies of the machine, where measured dimensions are entered. `body`: the one that is chosen first. */
export function EnterDimensions({ body = null }: { readonly body?: string | null }) {
  return (
    <Button kind="link" title="Open the bodies in the machine's profile" onClick={() => openBodies(body)}>
      Enter dimensions…
    </Button>
  );
}
