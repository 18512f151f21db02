/** The path to learn as a sheet: how far one is, the way on, and every lesson with its picture and its tick. */
import "./learn.css";

import { useEffect } from "react";

import { Doors } from "../../components/Doors";
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import { closeOverlay } from "../../session/document";
import { nextLesson } from "../../session/lesson";
import { lookForLessons, useLessons } from "../../session/lessons";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { listen } from "../../ui/effects";
import { Sheet } from "../../ui/Sheet";
import { Path } from "./Path";

// One chunk: an empty program shows a few of what the sheet shows all of.
export { Invitation } from "./Invitation";

/** How far one is, and the way on. */
function Far() {
  const { path, learned } = useLessons();
  const usable = (path ?? []).filter((one) => one.usable);
  const done = usable.filter(({ name }) => learned.includes(name)).length;
  const next = nextLesson(usable, learned, "");
  return (
    <div className="learn-far row wrap between">
      <p className="column" role="status" data-testid="learn-count">
        {next === null ? t("learn.whole") : t("learn.done-of", { done, total: usable.length })}
        <progress aria-hidden="true" max={Math.max(1, usable.length)} value={done} />
      </p>
      {next === null ? null : (
        <Button ink testId="learn-next" onClick={next.begin}>
          {t("learn.next", { name: text(next.label) })}
          <Icon name="arrow-right" size={16} />
        </Button>
      )}
    </div>
  );
}

export function LearnSheet() {
  const path = useLessons((lessons) => lessons.path);
  useEffect(() => {
    void lookForLessons();
    // Whoever writes a lesson looks at the page after saving its file.
    return listen(window, { focus: () => void lookForLessons() });
  }, []);
  return (
    <Sheet title={t("learn.open")} testId="learn-sheet" wide onClose={closeOverlay}>
      <div className="learn-room">
        <Doors />
        {path === null ? (
          <p className="sheet-note muted small-text">{t("open.loading")}</p>
        ) : (
          <>
            <Far />
            <Path lessons={path} />
          </>
        )}
      </div>
    </Sheet>
  );
}
