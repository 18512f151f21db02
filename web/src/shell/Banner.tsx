/** One message across the page: a failure or a question, with what can be done about it. Nothing waits for it. */
import { useRun } from "../run/run";
import { Icon } from "../theme";
import { Said } from "../words/Said";
import { t } from "../words/words";
import { type Banner as Message, dismissBanner, useDocument } from "./document";

function Strip({ said, onClose }: { said: Message; onClose: () => void }) {
  return (
    <div className={`banner banner-${said.kind}`} role={said.kind === "note" ? "status" : "alert"} data-testid="banner">
      <Icon name={said.kind === "error" ? "triangle-alert" : "info"} size={18} />
      <p>
        <strong>
          <Said text={said.message} />
        </strong>{" "}
        <Said text={said.help} />
      </p>
      {said.actions.map((action) => (
        <button type="button" key={action.label} className="button" onClick={action.run}>
          {action.label}
        </button>
      ))}
      {said.kind !== "question" ? (
        <button type="button" className="tool small" aria-label={t("banner.close")} onClick={onClose}>
          <Icon name="x" size={16} />
        </button>
      ) : null}
    </div>
  );
}

export function Banner() {
  const said = useDocument((document) => document.banner);
  const failure = useRun((run) => run.error);
  if (said !== null) return <Strip said={said} onClose={dismissBanner} />;
  if (failure !== null) {
    return <Strip said={{ kind: "error", ...failure, actions: [] }} onClose={useRun.getState().dismissError} />;
  }
  return null;
}
