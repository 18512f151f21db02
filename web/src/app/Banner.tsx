/** One message across the page: a failure or a question, with what can be done about it. Nothing waits for it. */
import { useEffect, useRef } from "react";

import { inPage } from "../api/transport";
import { Said } from "../i18n/Said";
import { t } from "../i18n/words";
import { type Banner as Notice, dismissBanner, useDocument } from "../session/document";
import { isCutOff, useLink } from "../session/journal";
import { useRun } from "../session/run";
import { Icon } from "../theme";
import { borrowFocus } from "../ui/borrow-focus";
import { Button } from "../ui/Button";
import { Tool } from "../ui/Tool";

function Strip({ said, onClose }: { said: Notice; onClose: () => void }) {
  const asks = said.takesFocus === true;
  const strip = useRef<HTMLDivElement>(null);
  useEffect(() => (asks ? borrowFocus(strip.current?.querySelector("button")) : undefined), [asks]);
  return (
    <div
      ref={strip}
      className={`banner row rigid gap-xl banner-${said.kind}`}
      role={said.kind === "note" ? "status" : "alert"}
      data-testid="banner"
      onKeyDown={asks ? (event) => event.key === "Escape" && onClose() : undefined}
    >
      <Icon name={said.kind === "error" ? "triangle-alert" : "info"} size={18} />
      <p>
        <strong>
          <Said text={said.message} />
        </strong>{" "}
        <Said text={said.help} />
      </p>
      {said.actions.map((action) => (
        <Button key={action.label} onClick={action.run}>
          {action.label}
        </Button>
      ))}
      {said.kind !== "question" ? (
        <Tool small icon="x" label={t("banner.close")} titled={false} onClick={onClose} />
      ) : null}
    </div>
  );
}

/** Nothing that is done here reaches the server: said until it does. In a static site Python is in the page. */
function CutOff() {
  const silent = useLink((link) => link.silent);
  const [name, help] = silent
    ? (["link.silent", "link.silent-help"] as const)
    : (["error.offline", "error.offline-help"] as const);
  return (
    <div className="banner banner-error row rigid gap-xl" role="alert" data-testid="cut-off">
      <Icon name="triangle-alert" size={18} />
      <p>
        <strong>
          <Said text={t(name)} />
        </strong>{" "}
        <Said text={t(help)} />
      </p>
    </div>
  );
}

export function Banner() {
  const cutOff = useLink(isCutOff) && !inPage();
  return (
    <>
      {cutOff ? <CutOff /> : null}
      <Message cutOff={cutOff} />
    </>
  );
}

function Message({ cutOff }: { cutOff: boolean }) {
  const said = useDocument((document) => document.banner);
  const failure = useRun((run) => run.error);
  // Said already.
  if (cutOff && said?.message === t("error.offline")) return null;
  if (said !== null) return <Strip key={said.message} said={said} onClose={dismissBanner} />;
  if (failure !== null) {
    return <Strip said={{ kind: "error", ...failure, actions: [] }} onClose={useRun.getState().dismissError} />;
  }
  return null;
}
