import { type ButtonHTMLAttributes, type ReactNode, type Ref, useId } from "react";
import "./controls.css";
import { Icon, type IconName } from "./icons";

export interface ButtonProps extends Omit<ButtonHTMLAttributes<HTMLButtonElement>, "disabled"> {
  /** `primary` is what leads on from here, one of a group; `danger` cannot be undone or moves a machine; `link` stands within text. */
  readonly kind?: "plain" | "primary" | "danger" | "quiet" | "link";
  readonly icon?: IconName;
  /** Why it cannot be used now: shown as its title and read to those who do not see it. */
  readonly why?: string | null | undefined;
  /** For a button that is on or off. */
  readonly pressed?: boolean;
  readonly small?: boolean;
  readonly children?: ReactNode;
  readonly ref?: Ref<HTMLButtonElement>;
}

/** A button. One that cannot be used keeps its focus and says why. With an icon alone it needs an `aria-label`. */
export function Button({
  kind = "plain",
  icon,
  why,
  pressed,
  small,
  children,
  className = "",
  onClick,
  title,
  ref,
  ...rest
}: ButtonProps) {
  const id = useId();
  const off = why !== undefined && why !== null;
  const classes = ["button", kind, small ? "small-button" : "", children === undefined ? "only-icon" : "", className];
  return (
    <>
      <button
        type="button"
        {...rest}
        ref={ref}
        className={classes.filter(Boolean).join(" ")}
        aria-disabled={off || undefined}
        aria-pressed={pressed}
        aria-describedby={off ? id : rest["aria-describedby"]}
        title={off ? why : title}
        onClick={off ? (event) => event.preventDefault() : onClick}
      >
        {icon && <Icon name={icon} />}
        {children}
      </button>
      {off && (
        <span id={id} className="visually-hidden">
          {why}
        </span>
      )}
    </>
  );
}
