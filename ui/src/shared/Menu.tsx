import { type KeyboardEvent, useCallback, useEffect, useLayoutEffect, useRef, useState } from "react";
import { Icon } from "./icons";
import "./menu.css";

export type MenuItem =
  | { readonly kind: "rule" }
  | {
      readonly kind: "item";
      readonly label: string;
      /** The key that does the same, as it is written on it. */
      readonly keys?: string | undefined;
      /** Why it cannot be used now. */
      readonly why?: string | null | undefined;
      readonly run: () => void;
      /** For what is on or off: `radio` of several. */
      readonly checked?: boolean;
      readonly radio?: boolean;
    }
  | { readonly kind: "menu"; readonly label: string; readonly items: readonly MenuItem[]; readonly why?: string | null };

/** The items that can have the focus. */
function entries(list: Element | null): HTMLElement[] {
  return [...(list?.querySelectorAll<HTMLElement>(":scope > [role^=menuitem], :scope > .menu-sub > [role=menuitem]") ?? [])];
}

/** Moves the focus within a list by `step`, around its ends. */
function step(list: Element | null, by: number): void {
  const items = entries(list);
  const now = items.indexOf(document.activeElement as HTMLElement);
  items[(now + by + items.length) % items.length]?.focus();
}

function MenuList({ label, items, close, back }: { readonly label: string; readonly items: readonly MenuItem[]; readonly close: () => void; readonly back?: () => void }) {
  const list = useRef<HTMLDivElement>(null);
  const [sub, setSub] = useState<number | null>(null);
  // The focus goes back to the item that the submenu belongs to: it would be nowhere otherwise.
  const closeSub = () => {
    list.current?.querySelector<HTMLElement>(":scope > .menu-sub > [aria-expanded=true]")?.focus();
    setSub(null);
  };
  const keys = (event: KeyboardEvent) => {
    const moves: Partial<Record<string, () => void>> = {
      ArrowDown: () => step(list.current, 1),
      ArrowUp: () => step(list.current, -1),
      Home: () => entries(list.current)[0]?.focus(),
      End: () => entries(list.current).at(-1)?.focus(),
    };
    if (back && (event.key === "ArrowLeft" || event.key === "Escape")) moves[event.key] = back;
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    event.stopPropagation();
    move();
  };
  useEffect(() => entries(list.current)[0]?.focus(), []);
  useLayoutEffect(() => {
    const box = list.current?.getBoundingClientRect();
    if (list.current && box && box.right > window.innerWidth - 8) list.current.classList.add("to-left");
  }, []);
  return (
    <div ref={list} className="menu" role="menu" aria-label={label} onKeyDown={keys}>
      {items.map((item, index) => {
        if (item.kind === "rule") return <div key={index} role="separator" className="menu-rule" />;
        if (item.kind === "menu") {
          return (
            <div key={index} className="menu-sub" role="none" onPointerEnter={() => !item.why && setSub(index)} onPointerLeave={closeSub}>
              <button
                type="button"
                role="menuitem"
                aria-haspopup="menu"
                aria-expanded={sub === index}
                aria-disabled={item.why ? true : undefined}
                title={item.why ?? undefined}
                className="menu-item"
                onClick={() => !item.why && setSub(index)}
                onKeyDown={(event) => {
                  if (event.key !== "ArrowRight" || item.why) return;
                  event.preventDefault();
                  event.stopPropagation();
                  setSub(index);
                }}
              >
                <span className="menu-check" />
                <span className="menu-label">{item.label}</span>
                <Icon name="right" size={12} />
              </button>
              {sub === index && <MenuList label={item.label} items={item.items} close={close} back={closeSub} />}
            </div>
          );
        }
        const role = item.checked === undefined ? "menuitem" : item.radio ? "menuitemradio" : "menuitemcheckbox";
        return (
          <button
            key={index}
            type="button"
            role={role}
            aria-checked={item.checked}
            aria-disabled={item.why ? true : undefined}
            title={item.why ?? undefined}
            className="menu-item"
            onClick={() => {
              if (item.why) return;
              close();
              item.run();
            }}
          >
            <span className="menu-check">{item.checked && <Icon name={item.radio ? "record" : "check"} size={12} />}</span>
            <span className="menu-label">{item.label}</span>
            {item.keys && <span className="menu-keys">{item.keys}</span>}
          </button>
        );
      })}
    </div>
  );
}

/** Menus beside each other, as at the top of a window: arrows go from one to the next. */
export function MenuBar({ menus }: { readonly menus: readonly { readonly label: string; readonly items: () => readonly MenuItem[] }[] }) {
  const [open, setOpen] = useState<number | null>(null);
  const bar = useRef<HTMLDivElement>(null);
  const heads = () => [...(bar.current?.querySelectorAll<HTMLElement>(".menu-head") ?? [])];
  // The focus goes back to the head: with the list it would be nowhere.
  const close = useCallback(() => {
    bar.current?.querySelector<HTMLElement>(".menu-head[aria-expanded=true]")?.focus();
    setOpen(null);
  }, []);
  useEffect(() => {
    if (open === null) return;
    const away = (event: PointerEvent) => {
      if (!bar.current?.contains(event.target as Node)) setOpen(null);
    };
    // Also where the focus is elsewhere, such as after hovering.
    const escape = (event: globalThis.KeyboardEvent) => {
      if (event.key !== "Escape") return;
      event.preventDefault();
      setOpen(null);
    };
    window.addEventListener("pointerdown", away, true);
    window.addEventListener("keydown", escape);
    return () => {
      window.removeEventListener("pointerdown", away, true);
      window.removeEventListener("keydown", escape);
    };
  }, [open]);
  const go = (by: number) => {
    const all = heads();
    const now = open ?? all.indexOf(document.activeElement as HTMLElement);
    const next = (now + by + menus.length) % menus.length;
    all[next]?.focus();
    if (open !== null) setOpen(next);
  };
  return (
    <div
      ref={bar}
      className="menu-bar"
      role="menubar"
      aria-label="Menus"
      onKeyDown={(event) => {
        if (event.key === "ArrowRight") go(1);
        else if (event.key === "ArrowLeft") go(-1);
        else if (event.key === "Escape" && open !== null) {
          heads()[open]?.focus();
          setOpen(null);
        } else return;
        event.preventDefault();
        event.stopPropagation();
      }}
      onBlur={(event) => {
        if (event.relatedTarget instanceof Node && !event.currentTarget.contains(event.relatedTarget)) setOpen(null);
      }}
    >
      {menus.map((menu, index) => (
        <div key={menu.label} className="menu-of" role="none">
          <button
            type="button"
            role="menuitem"
            aria-haspopup="menu"
            aria-expanded={open === index}
            tabIndex={index === 0 ? 0 : -1}
            className="menu-head"
            onClick={() => setOpen(open === index ? null : index)}
            onPointerEnter={() => open !== null && setOpen(index)}
            onKeyDown={(event) => {
              if (event.key !== "ArrowDown") return;
              event.preventDefault();
              setOpen(index);
            }}
          >
            {menu.label}
          </button>
          {open === index && <MenuList label={menu.label} items={menu.items()} close={close} />}
        </div>
      ))}
    </div>
  );
}
