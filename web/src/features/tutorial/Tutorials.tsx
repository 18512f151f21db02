/** Above the graph: the panel of the tutorial that is open, and the welcome. */
import "./welcome.css";

import { useEffect } from "react";

import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { reportError, useDocument } from "../../session/document";
import { openLesson, useLessons } from "../../session/lessons";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { later } from "../../ui/later";
import { Tool } from "../../ui/Tool";
import { begin, keepTutorials } from "./opening";
import { useTutorial, welcome } from "./state";

const TutorialPanel = later(() => import("./Panel").then((chunk) => chunk.TutorialPanel), reportError);

export function Tutorials() {
  const open = useTutorial((state) => state.tutorial !== null);
  useEffect(keepTutorials, []);
  return (
    <>
      {open ? <TutorialPanel /> : null}
      <Welcome />
    </>
  );
}

/** The first visit: offers a tutorial above the open mission. Shown once. */
export function Welcome() {
  const { all, welcomed } = useTutorial();
  const learns = useLessons((lessons) => openLesson(lessons) !== null);
  const path = useStudio((studio) => studio.file.path);
  const ready = useDocument((document) => document.ready);
  const [first] = (all ?? []).filter((one) => one.steps.length > 0);
  // Not above a mission of the folder; a new mission begins where the folder has none.
  if (!ready || welcomed || learns || first === undefined) return null;
  if (path !== "" && !path.startsWith("example:")) return null;
  return (
    <section
      className="welcome banner banner-note row rigid gap-xl"
      aria-label={t("tutorial.welcome")}
      data-testid="welcome"
    >
      <Icon name="graduation-cap" size={18} />
      <p>
        <strong>{t("tutorial.welcome")}</strong> <span className="welcome-help">{t("tutorial.welcome-help")}</span>
      </p>
      <Button testId="welcome-tutorial" onClick={() => void begin(first)}>
        {text(first.label)}
      </Button>
      <Tool small icon="x" label={t("tutorial.not-now")} testId="welcome-close" onClick={welcome} />
    </section>
  );
}
