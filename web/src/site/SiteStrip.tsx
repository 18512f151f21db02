/** One line about the studio of a static site: that it is coming, what keeps it away, and whether the browser keeps the work. */
import { useLanguage } from "../i18n/language";
import { type Key, t } from "../i18n/words";
import { useDocument } from "../session/document";
import { useRun } from "../session/run";
import { Icon } from "../theme";
import { useSite } from "./state";
import { Button } from "../ui/Button";
import "./site.css";

interface Told {
  kind: "note" | "error";
  message: string;
  help: Key | null;
  action: [Key, () => void] | null;
  share?: number;
}

const PERCENT = 100;
const again: [Key, () => void] = ["site.again", () => window.location.reload()];

/** Robots of a run that are too many for steps that nothing compiles. */
const CROWD = 100;

function useTold(): Told | null {
  const crowd = useRun(({ status, agents }) => status === "running" && agents.length >= CROWD);
  const { phase, fetched, keeping, renew, renewing } = useSite();
  const meanwhile = useDocument(({ ahead }) => ahead) ? "site.meanwhile" : null;
  switch (phase) {
    case "fetching":
      return {
        kind: "note",
        message: t("site.fetching", { percent: Math.floor(PERCENT * fetched) }),
        help: meanwhile,
        action: null,
        share: fetched,
      };
    case "starting":
      return { kind: "note", message: t("site.starting"), help: meanwhile, action: null, share: 1 };
    case "other-tab":
      return { kind: "note", message: t("site.other-tab"), help: "site.other-tab-help", action: null };
    case "unfetched":
      return { kind: "error", message: t("site.unfetched"), help: "site.unfetched-help", action: again };
    case "broken":
      return { kind: "error", message: t("site.broken"), help: "site.broken-help", action: again };
    case "ready":
      break;
  }
  if (keeping === "full") return { kind: "error", message: t("site.full"), help: "site.full-help", action: null };
  if (keeping === "denied") return { kind: "error", message: t("site.denied"), help: "site.denied-help", action: null };
  if (keeping === "unread")
    return { kind: "error", message: t("site.unread"), help: "site.unread-help", action: again };
  if (crowd && renew === null) {
    return { kind: "note", message: t("site.crowd"), help: "site.crowd-help", action: null };
  }
  if (renew === null) return null;
  if (renewing) return { kind: "note", message: t("site.renewing"), help: "site.renewing-help", action: null };
  return { kind: "note", message: t("site.newer"), help: null, action: ["site.renew", renew] };
}

export function SiteStrip() {
  useLanguage((state) => state.language);
  const told = useTold();
  const reason = useSite((state) => state.reason);
  if (told === null) return null;
  const [label, act] = told.action ?? [null, () => undefined];
  return (
    <div
      className={`site-strip row gap-xl site-${told.kind}`}
      data-testid="site"
      role={told.kind === "note" ? "status" : "alert"}
    >
      <Icon name={told.kind === "error" ? "triangle-alert" : "info"} size={18} />
      <p title={reason}>
        <strong>{told.message}</strong> {told.help === null ? null : t(told.help)}
      </p>
      {told.share === undefined ? null : <progress value={told.share} aria-label={told.message} />}
      {label === null ? null : <Button onClick={act}>{t(label)}</Button>}
    </div>
  );
}
