/** What is different between the open mission and its file, in words. */
import { useEffect, useState } from "react";

import { journalApi } from "../api/journal";
import { Said } from "../i18n/Said";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { closeOverlay } from "../session/document";
import { Sheet } from "../ui/Sheet";

export function DifferenceSheet() {
  const [changes, setChanges] = useState<string[] | null>(null);
  useEffect(() => {
    let alive = true;
    const { file, mission } = useStudio.getState();
    journalApi.difference(file.path, mission).then(
      (found) => {
        if (alive) setChanges(found.changes);
      },
      (cause: unknown) => {
        if (alive) setChanges([cause instanceof Error ? cause.message : String(cause)]);
      },
    );
    return () => {
      alive = false;
    };
  }, []);
  return (
    <Sheet title={t("difference.title")} testId="difference-dialog" wide onClose={closeOverlay}>
      {changes === null ? (
        <p>{t("open.loading")}</p>
      ) : changes.length === 0 ? (
        <p>{t("difference.none")}</p>
      ) : (
        <>
          <p>{t("difference.intro")}</p>
          <ul data-testid="differences">
            {changes.map((change, at) => (
              <li key={at}>
                <Said text={change} />
              </li>
            ))}
          </ul>
        </>
      )}
    </Sheet>
  );
}
