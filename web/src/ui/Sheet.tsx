/**
 * A card over the page for a list or a short form; Escape, its button and a click beside it close it.
 *
 * It is not modal: STOP has to work at any moment.
 */
import { type ReactNode, useEffect, useRef } from "react";

import { t } from "../i18n/words";
import "./sheets.css";
import { Tool } from "./Tool";

interface SheetProps {
  title: string;
  testId: string;
  children: ReactNode;
  wide?: boolean;
  onClose: () => void;
}

export function Sheet({ title, testId, children, wide = false, onClose }: SheetProps) {
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
          <Tool small icon="x" label={t("help.close")} titled={false} onClick={onClose} />
        </div>
        {children}
      </div>
    </dialog>
  );
}
