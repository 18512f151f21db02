/** What this program is. */
import { t } from "../i18n/words";
import { closeOverlay, useDocument } from "../session/document";
import { Sheet } from "../ui/Sheet";

export function AboutSheet() {
  const version = useDocument((document) => document.session?.version ?? "");
  return (
    <Sheet title={t("app.name")} testId="about-dialog" onClose={closeOverlay}>
      <p>{t("help.about-text", { version })}</p>
      <p>
        {t("help.about-graph")}{" "}
        <a href="https://reactflow.dev" target="_blank" rel="noreferrer">
          React Flow
        </a>
        {" · "}
        <a href="licenses.md" target="_blank" rel="noreferrer">
          {t("help.about-licences")}
        </a>
      </p>
    </Sheet>
  );
}
