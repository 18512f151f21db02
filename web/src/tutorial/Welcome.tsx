/** For somebody who is here for the first time, above the mission that runs: what can be done now. Shown once. */
import { useStudio } from "../model/studio";
import { text } from "../model/texts";
import { Icon } from "../theme";
import { t } from "../words/words";
import { begin } from "./opening";
import { useTutorial, welcome } from "./state";
import "./welcome.css";

export function Welcome() {
  const { all, tutorial, welcomed } = useTutorial();
  const path = useStudio((studio) => studio.file.path);
  const [first] = (all ?? []).filter((one) => one.steps.length > 0);
  // Who opens a mission of their own knows the way; a new one begins where the folder holds none.
  if (welcomed || tutorial !== null || first === undefined) return null;
  if (path !== "" && !path.startsWith("example:")) return null;
  return (
    <section className="welcome" aria-label={t("tutorial.welcome")} data-testid="welcome">
      <Icon name="graduation-cap" size={18} />
      <p>
        <strong>{t("tutorial.welcome")}</strong> {t("tutorial.welcome-help")}
      </p>
      <button type="button" className="button" data-testid="welcome-tutorial" onClick={() => void begin(first)}>
        {text(first.label)}
      </button>
      <button
        type="button"
        className="tool small"
        aria-label={t("tutorial.not-now")}
        title={t("tutorial.not-now")}
        data-testid="welcome-close"
        onClick={welcome}
      >
        <Icon name="x" size={16} />
      </button>
    </section>
  );
}
