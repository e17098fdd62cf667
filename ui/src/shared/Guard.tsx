import { Component, type ReactNode } from "react";
import { Button } from "./controls/Button";
import "./guard.css";

interface Failed {
  /** Why; null while all is well. */
  readonly problem: string | null;
}

/** A part of the window. Where a mistake in it ends it, the other parts keep working, and above all STOP does. */
export class Guard extends Component<{ readonly name: string; readonly children: ReactNode }, Failed> {
  override state: Failed = { problem: null };

  static getDerivedStateFromError(error: unknown): Failed {
    return { problem: error instanceof Error ? error.message : String(error) };
  }

  override render(): ReactNode {
    const { name, children } = this.props;
    const { problem } = this.state;
    if (problem === null) return children;
    return (
      <div className="guard" role="alert">
        <p>
          <strong>{name}</strong> cannot be shown because of an internal error: {problem}. Nothing of the design is
          lost.
        </p>
        <Button small onClick={() => this.setState({ problem: null })}>
          Show it again
        </Button>
      </div>
    );
  }
}
