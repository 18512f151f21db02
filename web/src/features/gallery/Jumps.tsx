/** Buttons that lead to the headings of a long list, which features fill. */
import { useEffect, useRef, useState } from "react";

import { t } from "../../i18n/words";

export function Jumps() {
  const nav = useRef<HTMLElement>(null);
  const [headings, setHeadings] = useState<readonly HTMLElement[]>([]);
  useEffect(() => {
    const list = nav.current?.parentElement;
    if (!list) return;
    const look = () => {
      const found = [...list.querySelectorAll<HTMLElement>("h3")];
      setHeadings((before) =>
        found.length === before.length && found.every((one, i) => one === before[i]) ? before : found,
      );
    };
    look();
    const observer = new MutationObserver(look);
    observer.observe(list, { childList: true, subtree: true });
    return () => observer.disconnect();
  }, []);
  return (
    <nav ref={nav} className="open-jumps wrap flex gap-m" aria-label={t("open.jumps")}>
      {headings.map((heading) => (
        <button
          key={heading.textContent}
          type="button"
          className="gallery-chip finger small-text hover"
          dir="auto"
          onClick={() => {
            heading.scrollIntoView();
            heading.tabIndex = -1;
            heading.focus({ preventScroll: true });
          }}
        >
          {heading.textContent}
        </button>
      ))}
    </nav>
  );
}
