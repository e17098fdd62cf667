import type { ReactNode } from "react";

/** Something that scrolls where it is long, also by keys: it can have the focus for that, and is named for it. */
export function Scrolls({
  label,
  className,
  children,
}: {
  readonly label: string;
  readonly className: string;
  readonly children: ReactNode;
}) {
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: who has no pointer scrolls it by keys
    <section className={className} aria-label={label} tabIndex={0}>
      {children}
    </section>
  );
}
