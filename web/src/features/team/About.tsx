/** The mission's title and what happens in it, in the language of the page; English stands in for another one. */
import { languageInUse, t } from "../../i18n/words";
import { changeTitle } from "../../model/commands/changeTitle";
import { useStudio } from "../../model/studio";
import { Field } from "../../ui/Field";

export function About() {
  const label = useStudio((studio) => studio.mission.label);
  const help = useStudio((studio) => studio.mission.help);
  const spoken = languageInUse();
  const language = spoken === "en" ? "" : spoken;
  const change = (what: "label" | "help", words: string) => {
    const command = changeTitle(useStudio.getState().mission, what, language, words);
    if (command !== null) useStudio.getState().execute(command);
  };
  return (
    <section className="team-part surface" aria-labelledby="team-about">
      <h2 id="team-about">{t("team.about")}</h2>
      <Field label={t("team.title")}>
        <input
          className="field"
          data-testid="team-title"
          dir="auto"
          value={label?.[language] ?? ""}
          placeholder={label?.[""] ?? ""}
          onChange={(event) => change("label", event.target.value)}
        />
      </Field>
      <Field label={t("team.help")}>
        <textarea
          className="field"
          data-testid="team-help"
          dir="auto"
          rows={2}
          value={help?.[language] ?? ""}
          placeholder={help?.[""] ?? ""}
          onChange={(event) => change("help", event.target.value)}
        />
      </Field>
    </section>
  );
}
