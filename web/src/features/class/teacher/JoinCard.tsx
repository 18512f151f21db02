/** How pupils come in: address, code and QR code, small beside the exercise or large over the page. */
import { useEffect, useRef } from "react";

import { t } from "../../../i18n/words";
import { Icon } from "../../../theme";
import { Qr } from "./Qr";
import { useDesk } from "./store";
import { borrowFocus } from "../../../ui/borrow-focus";

export function codeWords(code: string): string {
  return `${code.slice(0, 3)} ${code.slice(3)}`;
}

export function JoinCard({ large, onLarge }: { large: boolean; onLarge?: () => void }) {
  const news = useDesk((desk) => desk.news);
  if (news === null) return null;
  const address = news.address.replace(/^http:\/\//, "").replace(/\/$/, "");
  return (
    <section className="class-join surface row rigid gap-2xl" data-large={large} data-testid="class-join">
      <Qr rows={news.qr} label={t("teacher.qr")} />
      <div className="column slim">
        <span className="class-muted muted small-text">{t("teacher.join-at")}</span>
        <code className="breakable" dir="ltr">
          {address}
        </code>
        {news.code === "" ? (
          <strong>{t("teacher.no-code")}</strong>
        ) : (
          <strong className="class-code nowrap" dir="ltr" data-testid="class-code">
            {codeWords(news.code)}
          </strong>
        )}
        {onLarge === undefined ? null : (
          <button type="button" className="class-plain text-button inline-row" onClick={onLarge}>
            <Icon name="maximize" size={16} />
            {t("teacher.show-large")}
          </button>
        )}
      </div>
    </section>
  );
}

/** Fills the screen, for a projector; any key or press closes it. */
export function LargeJoin({ onClose }: { onClose: () => void }) {
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => borrowFocus(place.current), []);
  return (
    <div
      className="class-large centred"
      role="dialog"
      aria-label={t("teacher.join-at")}
      tabIndex={-1}
      ref={place}
      onClick={onClose}
      onKeyDown={(event) => {
        event.stopPropagation();
        onClose();
      }}
    >
      <JoinCard large />
    </div>
  );
}
