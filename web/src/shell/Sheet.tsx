/**
 * A card over the page for a list or a short form; Escape, its button and a click beside it close it.
 *
 * The page behind it stays alive: STOP has to work at any moment.
 */
import { type ReactNode, useEffect, useRef } from "react";

import { Icon } from "../theme";
import { t } from "../words/words";
import { show } from "./document";
import "./sheets.css";

interface SheetProps {
  title: string;
  testId: string;
  children: ReactNode;
  wide?: boolean;
  onClose?: () => void;
}

const nothingOver = () => {
  show(null);
};

export function Sheet({ title, testId, children, wide = false, onClose = nothingOver }: SheetProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  const close = useRef(onClose);
  useEffect(() => {
    close.current = onClose;
  });
  useEffect(() => {
    const element = dialog.current;
    const before = document.activeElement;
    if (element !== null && !element.contains(before)) element.querySelector<HTMLElement>("button, input")?.focus();
    const outside = (event: PointerEvent) => {
      if (event.target instanceof Node && element?.contains(event.target) !== true) close.current();
    };
    document.addEventListener("pointerdown", outside);
    return () => {
      document.removeEventListener("pointerdown", outside);
      if (before instanceof HTMLElement) before.focus();
    };
  }, []);
  return (
    <dialog
      className={wide ? "sheet sheet-wide" : "sheet"}
      ref={dialog}
      data-testid={testId}
      aria-labelledby={`${testId}-title`}
      open
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        onClose();
      }}
    >
      <div className="sheet-body">
        <div className="sheet-head">
          <h2 id={`${testId}-title`}>{title}</h2>
          <button type="button" className="tool small" aria-label={t("help.close")} onClick={onClose}>
            <Icon name="x" size={16} />
          </button>
        </div>
        {children}
      </div>
    </dialog>
  );
}
