import "./controls.css";

/** One of two words that a button has in turn, in the width of the longer one: nothing moves when it is the other's turn. */
export function Either({ shown, other }: { readonly shown: string; readonly other: string }) {
  return (
    <span className="either" data-other={other}>
      {shown}
    </span>
  );
}
