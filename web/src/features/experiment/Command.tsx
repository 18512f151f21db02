/** A command line, for copying. */
import { CopyButton } from "../../components/CopyButton";
import { t } from "../../i18n/words";

export function Command({ text }: { text: string }) {
  return (
    <div className="experiment-command row">
      <code dir="ltr" tabIndex={0} role="textbox" aria-readonly="true" aria-label={t("experiment.command")}>
        {text}
      </code>
      <CopyButton text={text} label={t("experiment.copy")} copied={t("experiment.copied")} testId="copy-command" />
    </div>
  );
}
