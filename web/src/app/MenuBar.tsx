/** The menu bar: opened by click, by Alt, or by arrows; closed by Escape or a click elsewhere. */
import { type KeyboardEvent, useEffect, useRef, useState } from "react";

import { mirrored } from "../i18n/language";
import { t } from "../i18n/words";
import { listen } from "../ui/effects";
import { useFolding } from "../ui/folding";
import { Menu } from "../ui/Menu";
import { menuInCommon, type MenuPart } from "../ui/menu-model";

/** Calls back when Alt is pressed and let go with nothing in between. */
function useLoneAlt(callback: () => void): void {
  useEffect(() => {
    let alone = false;
    const down = (event: globalThis.KeyboardEvent) => {
      alone = event.key === "Alt" && !event.repeat && !event.ctrlKey && !event.shiftKey && !event.metaKey;
    };
    const up = (event: globalThis.KeyboardEvent) => {
      if (event.key === "Alt" && alone) {
        event.preventDefault();
        callback();
      }
      alone = false;
    };
    const spoiled = () => {
      alone = false;
    };
    return listen(window, { keydown: down, keyup: up, pointerdown: spoiled, blur: spoiled });
  }, [callback]);
}

/** Menus without room have a menu in common, at the end; the last one gives way first. */
export function MenuBar({ menus: all }: { menus: MenuPart[] }) {
  const [opened, setOpen] = useState(-1);
  const [reached, setAt] = useState(0);
  const bar = useRef<HTMLDivElement>(null);
  const folded = useFolding(bar);
  const common = menuInCommon(all.slice(all.length - folded), t("menu.more"));
  const menus = folded === 0 ? all : [...all.slice(0, all.length - folded), common];
  const [open, at] = [opened < menus.length ? opened : -1, Math.min(reached, menus.length - 1)];
  const cameFrom = useRef<HTMLElement | null>(null);

  const focusTitle = (index: number) => {
    bar.current?.querySelectorAll<HTMLElement>("[data-title]")[index]?.focus();
  };
  const close = () => {
    setOpen(-1);
    focusTitle(at);
  };
  const aside = (toRight: 1 | -1) => {
    const by = mirrored() ? -toRight : toRight;
    const next = (at + by + menus.length) % menus.length;
    setAt(next);
    if (open >= 0) setOpen(next);
    else focusTitle(next);
  };
  const [loneAlt] = useState(() => () => {
    const active = document.activeElement;
    if (active instanceof HTMLElement && bar.current?.contains(active) === true) {
      setOpen(-1);
      cameFrom.current?.focus();
      return;
    }
    cameFrom.current = active instanceof HTMLElement ? active : null;
    setAt(0);
    bar.current?.querySelector<HTMLElement>("[data-title]")?.focus();
  });
  useLoneAlt(loneAlt);

  useEffect(() => {
    if (open < 0) return;
    const outside = (event: PointerEvent) => {
      if (event.target instanceof Node && bar.current?.contains(event.target) === true) return;
      setOpen(-1);
    };
    return listen(document, { pointerdown: outside }, { capture: true });
  }, [open]);

  const onTitleKey = (event: KeyboardEvent, index: number) => {
    if (event.key === "ArrowLeft") aside(-1);
    else if (event.key === "ArrowRight") aside(1);
    else if (event.key === "ArrowDown" || event.key === "Enter" || event.key === " ") setOpen(index);
    else if (event.key === "Escape") {
      setOpen(-1);
      cameFrom.current?.focus();
    } else if (event.key.length === 1 && !event.ctrlKey && !event.altKey && !event.metaKey) {
      // A letter opens the next menu that begins with it.
      const wanted = event.key.toLowerCase();
      const order = menus.map((_, by) => (index + 1 + by) % menus.length);
      const found = order.find((one) => menus[one]?.label.toLowerCase().startsWith(wanted) === true);
      if (found === undefined) return;
      setAt(found);
      setOpen(found);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <div className="menubar flex slim" role="menubar" aria-label={t("menu.bar")} ref={bar}>
      {[...all, common].map((menu, place) => {
        // The menu in common stands behind those that are shown; the others wait in the page to be measured.
        const last = menu === common;
        const index = menus.indexOf(menu);
        const there = index >= 0;
        return (
          <div
            className="menubar-part rigid relative"
            key={menu.id}
            role="none"
            {...(last ? { "data-folded": "" } : place === 0 ? {} : { "data-fold": all.length - place })}
          >
            <button
              type="button"
              role="menuitem"
              className="menubar-title small-text nowrap medium focus-inside"
              {...(there ? { "data-title": "" } : {})}
              data-testid={`menu-${menu.id}`}
              aria-haspopup="menu"
              aria-expanded={there && open === index}
              tabIndex={there && at === index ? 0 : -1}
              onClick={() => {
                setAt(index);
                setOpen(open === index ? -1 : index);
              }}
              onPointerEnter={({ pointerType }) => {
                // A finger comes only to press: the click that follows would close what opened here.
                if (open < 0 || pointerType === "touch") return;
                setAt(index);
                setOpen(index);
              }}
              onFocus={() => setAt(index)}
              onKeyDown={(event) => onTitleKey(event, index)}
            >
              {menu.label}
            </button>
            {there && open === index ? (
              <Menu
                key={menu.id}
                id={`menu-list-${menu.id}`}
                label={menu.label}
                entries={menu.entries}
                onClose={close}
                onAside={aside}
              />
            ) : null}
          </div>
        );
      })}
    </div>
  );
}
