/** What this program is. */
import { t } from "../words/words";
import { useDocument } from "./document";
import { Sheet } from "./Sheet";

export function AboutSheet() {
  const version = useDocument((document) => document.session?.version ?? "");
  return (
    <Sheet title={t("app.name")} testId="about-dialog">
      <p>{t("help.about-text", { version })}</p>
    </Sheet>
  );
}
