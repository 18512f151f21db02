/** What the panel says where no robot is: how one gets there, and what this kind of computer may want first. */
import { inPage } from "../../api/line";
import { t } from "../../i18n/words";

type System = "linux" | "windows" | "other";

/** The kind of computer that this page is on. */
export function systemOf(userAgent: string): System {
  if (/windows/i.test(userAgent)) return "windows";
  return /linux|cros|x11/i.test(userAgent) && !/android/i.test(userAgent) ? "linux" : "other";
}

export function EmptyRobots() {
  const system = systemOf(navigator.userAgent);
  return (
    <div className="robots-empty" data-testid="robots-empty">
      <h3>{t("boards.none")}</h3>
      <ol>
        <li>{t("boards.none-plug")}</li>
        <li>{t(inPage() ? "boards.none-choose" : "boards.none-appears")}</li>
      </ol>
      <details>
        <summary>{t("boards.none-trouble")}</summary>
        {system === "linux" ? (
          <>
            <p>{t("boards.none-linux")}</p>
            <pre dir="ltr">sudo usermod -aG dialout $USER</pre>
          </>
        ) : null}
        {system === "windows" ? <p>{t("boards.none-windows")}</p> : null}
        <p>{t("boards.none-cable")}</p>
      </details>
    </div>
  );
}
