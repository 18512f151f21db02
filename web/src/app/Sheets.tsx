/** The sheets of the page itself, in a chunk of their own: none is open at first. */
import { t } from "../i18n/words";
import { closeOverlay, useDocument } from "../session/document";
import { Sheet } from "../ui/Sheet";

export { DifferenceSheet } from "./DifferenceSheet";
export { SaveAsSheet } from "./SaveAsSheet";
export { ShortcutsSheet } from "./Shortcuts";

/** What this program is. */
export function AboutSheet() {
  const version = useDocument((document) => document.session?.version ?? "");
  return (
    <Sheet title={t("app.name")} testId="about-dialog" onClose={closeOverlay}>
      <p className="below">{t("help.about-text", { version })}</p>
      <p>
        <a href="licenses.md" target="_blank" rel="noreferrer">
          {t("help.about-licences")}
        </a>
      </p>
    </Sheet>
  );
}
