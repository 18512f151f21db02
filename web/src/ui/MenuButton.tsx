/** A button that opens a menu under itself; the focus comes back to it. */
import { type ComponentProps, useRef, useState } from "react";

import { FloatingMenu } from "./FloatingMenu";
import type { MenuEntry } from "./menu-model";

interface MenuButtonProps extends Omit<ComponentProps<"button">, "type" | "id" | "ref" | "onClick"> {
  /** Names the menu (`FloatingMenu`) and the button. */
  id: string;
  /** The menu's label and the button's title. */
  label: string;
  entries: readonly MenuEntry[];
}

export function MenuButton({ id, label, entries, ...rest }: MenuButtonProps) {
  const [at, setAt] = useState<{ x: number; y: number } | null>(null);
  const button = useRef<HTMLButtonElement>(null);
  return (
    <>
      <button
        type="button"
        ref={button}
        title={label}
        aria-haspopup="menu"
        aria-expanded={at !== null}
        data-testid={id}
        {...rest}
        onClick={(event) => {
          const box = event.currentTarget.getBoundingClientRect();
          setAt({ x: box.left, y: box.bottom + 4 });
        }}
      />
      {at === null ? null : (
        <FloatingMenu
          id={id}
          label={label}
          at={at}
          entries={entries}
          onLeave={() => setAt(null)}
          onClose={() => {
            setAt(null);
            button.current?.focus();
          }}
        />
      )}
    </>
  );
}
