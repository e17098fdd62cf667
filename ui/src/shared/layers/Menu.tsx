import * as Radix from "@radix-ui/react-menubar";
import { type KeyboardEvent, type RefObject, useEffect, useRef, useState } from "react";
import { Icon } from "../controls/icons";
import "./menu.css";

interface Item {
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

interface Submenu {
  readonly kind: "menu";
  readonly label: string;
  readonly items: readonly MenuItem[];
  readonly why?: string | null;
}

export type MenuItem = { readonly kind: "rule" } | Item | Submenu;

/** px between a head and its menu, from the edges of the window, and of a submenu over its own. */
const APART = 4;
export const FROM_EDGE = 8;
const OVER = -2;
/** px: the first item of a submenu is beside the one that it hangs from. */
const UP = -7;

/** An item that cannot be used can have the focus, which shows why, and is chosen in vain. */
const offOf = (why: string | null | undefined) => ({
  "aria-disabled": why ? true : undefined,
  title: why ?? undefined,
});

/** Does what was chosen, with the focus where it was before the menu: what it opens gives it back there. */
type Choose = (run: () => void) => void;

const LIST = "[role=menu], [role=menubar]";

/**
 * Moves the focus within a menu, or within the bar, around their ends. At once: Radix does it a moment later, and of keys that are pressed
 * quickly while the view is drawn it loses some.
 */
function moveFocus(event: KeyboardEvent, back: string, on: string): void {
  const list = event.currentTarget;
  // Also heard of menus within this one.
  if (!(event.target instanceof Element) || event.target.closest(LIST) !== list) return;
  const items = [...list.querySelectorAll<HTMLElement>("[role^=menuitem]")].filter(
    (item) => item.closest(LIST) === list,
  );
  const now = items.indexOf(document.activeElement as HTMLElement);
  const to = { [back]: now - 1, [on]: now + 1, Home: 0, End: -1 }[event.key];
  if (to === undefined) return;
  event.preventDefault();
  event.stopPropagation();
  items.at(to % items.length)?.focus();
}

export const withinMenu = (event: KeyboardEvent) => moveFocus(event, "ArrowUp", "ArrowDown");
const withinBar = (event: KeyboardEvent) => moveFocus(event, "ArrowLeft", "ArrowRight");

function Choice({ item, choose }: { readonly item: Item; readonly choose: Choose }) {
  const { label, keys, why, checked, radio } = item;
  const props = {
    ...offOf(why),
    className: "menu-item",
    onSelect: (event: Event) => (why ? event.preventDefault() : choose(item.run)),
  };
  const shown = (
    <>
      <span className="menu-check">{checked && <Icon name={radio ? "record" : "check"} size={12} />}</span>
      <span className="menu-label">{label}</span>
      {keys && <span className="menu-keys">{keys}</span>}
    </>
  );
  if (checked === undefined) return <Radix.Item {...props}>{shown}</Radix.Item>;
  if (!radio)
    return (
      <Radix.CheckboxItem {...props} checked={checked}>
        {shown}
      </Radix.CheckboxItem>
    );
  return (
    <Radix.RadioItem {...props} value={label}>
      {shown}
    </Radix.RadioItem>
  );
}

function Sub({ label, items, why, choose }: Submenu & { readonly choose: Choose }) {
  const [open, setOpen] = useState(false);
  const trigger = useRef<HTMLDivElement>(null);
  const shown = (
    <>
      <span className="menu-check" />
      <span className="menu-label">{label}</span>
      <Icon name="right" size={12} />
    </>
  );
  if (why)
    return (
      <Radix.Item {...offOf(why)} className="menu-item" onSelect={(event) => event.preventDefault()}>
        {shown}
      </Radix.Item>
    );
  return (
    <Radix.Sub open={open} onOpenChange={setOpen}>
      <Radix.SubTrigger ref={trigger} className="menu-item">
        {shown}
      </Radix.SubTrigger>
      <Radix.SubContent
        className="menu"
        aria-label={label}
        loop
        sideOffset={OVER}
        alignOffset={UP}
        collisionPadding={FROM_EDGE}
        onKeyDownCapture={withinMenu}
        onEscapeKeyDown={(event) => {
          // This menu alone: the one that it hangs from stays.
          event.preventDefault();
          setOpen(false);
          trigger.current?.focus();
        }}
      >
        <Items items={items} choose={choose} />
      </Radix.SubContent>
    </Radix.Sub>
  );
}

function Items({ items, choose }: { readonly items: readonly MenuItem[]; readonly choose: Choose }) {
  const all = items.map((item, index) => {
    // The items of a menu do not change while it is open, and two may have the same name.
    const key = `${item.kind} ${index}`;
    if (item.kind === "rule") return <Radix.Separator key={key} className="menu-rule" />;
    if (item.kind === "menu") return <Sub key={key} {...item} choose={choose} />;
    return <Choice key={key} item={item} choose={choose} />;
  });
  const radios = items.filter((item) => item.kind === "item").filter(({ radio }) => radio);
  if (radios.length === 0) return all;
  return <Radix.RadioGroup value={radios.find(({ checked }) => checked)?.label ?? ""}>{all}</Radix.RadioGroup>;
}

interface Menu {
  readonly label: string;
  readonly items: () => readonly MenuItem[];
}

/** What is in a menu while it is open: asked for when it opens, since what can be done may have changed since it was open last. */
export function Opened({
  items,
  choose,
  list,
}: {
  readonly items: Menu["items"];
  readonly choose: Choose;
  readonly list: RefObject<HTMLElement | null>;
}) {
  // The first item has the focus, also where the pointer has opened the menu: the next key is for it.
  useEffect(() => list.current?.querySelector<HTMLElement>("[role^=menuitem]")?.focus(), [list]);
  return <Items items={items()} choose={choose} />;
}

function OneMenu({ label, items, close }: Menu & { readonly close: () => void }) {
  const head = useRef<HTMLButtonElement>(null);
  const list = useRef<HTMLDivElement>(null);
  // At once: the next key would be for the whole window.
  const back = () => head.current?.focus();
  return (
    <Radix.Menu value={label}>
      <Radix.Trigger ref={head} className="menu-head">
        {label}
      </Radix.Trigger>
      <Radix.Content
        ref={list}
        className="menu"
        loop
        sideOffset={APART}
        collisionPadding={FROM_EDGE}
        onKeyDownCapture={(event) => {
          withinMenu(event);
          if (event.key !== "Tab") return;
          // It leads on from the head, and not from one item to the next.
          event.stopPropagation();
          back();
          close();
        }}
        onEscapeKeyDown={back}
        onCloseAutoFocus={(event) => event.preventDefault()}
      >
        <Opened
          items={items}
          list={list}
          choose={(run) => {
            back();
            run();
          }}
        />
      </Radix.Content>
    </Radix.Menu>
  );
}

/** Menus beside each other, as at the top of a window: arrows go from one to the next. */
export function MenuBar({ menus }: { readonly menus: readonly Menu[] }) {
  const [open, setOpen] = useState("");
  return (
    <Radix.Root
      className="menu-bar"
      aria-label="Menus"
      value={open}
      onValueChange={setOpen}
      onKeyDownCapture={withinBar}
    >
      {menus.map((menu) => (
        <OneMenu key={menu.label} {...menu} close={() => setOpen("")} />
      ))}
    </Radix.Root>
  );
}
