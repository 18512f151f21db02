/**
 * A card over the page for a list or a short form; Escape, its button and a click beside it close it.
 *
 * It is not modal: STOP has to work at any moment.
 */
import "./sheets.css";

import { type ReactNode, useEffect, useRef } from "react";

import { t } from "../i18n/words";
import { borrowFocus } from "./borrow-focus";
import { endAll, listen } from "./effects";
import { Tool } from "./Tool";

interface SheetProps {
  title: string;
  testId: string;
  children: ReactNode;
  wide?: boolean;
  /** It takes all of the room that its parent has. */
  whole?: boolean;
  onClose: () => void;
}

export function Sheet({ title, testId, children, wide = false, whole = false, onClose }: SheetProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  const close = useRef(onClose);
  useEffect(() => {
    close.current = onClose;
  });
  useEffect(() => {
    const element = dialog.current;
    const has = element?.contains(document.activeElement) === true;
    const giveBack = borrowFocus(has ? null : element?.querySelector<HTMLElement>("button, input"));
    const outside = (event: PointerEvent) => {
      if (event.target instanceof Node && element?.contains(event.target) !== true) close.current();
    };
    return endAll(listen(document, { pointerdown: outside }), giveBack);
  }, []);
  return (
    <dialog
      className={whole ? "sheet sheet-whole" : wide ? "sheet sheet-wide" : "sheet"}
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
        <div className="sheet-head between aligned">
          <h2 id={`${testId}-title`}>{title}</h2>
          <Tool small icon="x" label={t("help.close")} titled={false} onClick={onClose} />
        </div>
        {children}
      </div>
    </dialog>
  );
}
