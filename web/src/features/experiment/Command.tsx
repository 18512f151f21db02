/** A command line, for copying. */
import { useEffect, useState } from "react";

import { t } from "../../i18n/words";
import { Tool } from "../../ui/Tool";

const COPIED_MS = 2000;

export function Command({ text }: { text: string }) {
  const [copied, setCopied] = useState(false);
  useEffect(() => {
    if (!copied) return;
    const timer = setTimeout(() => setCopied(false), COPIED_MS);
    return () => clearTimeout(timer);
  }, [copied]);
  return (
    <div className="experiment-command row">
      <code dir="ltr" tabIndex={0} role="textbox" aria-readonly="true" aria-label={t("experiment.command")}>
        {text}
      </code>
      <Tool
        small
        icon={copied ? "check" : "copy"}
        label={copied ? t("experiment.copied") : t("experiment.copy")}
        testId="copy-command"
        onClick={() => {
          navigator.clipboard.writeText(text).then(
            () => setCopied(true),
            () => setCopied(false),
          );
        }}
      />
    </div>
  );
}
