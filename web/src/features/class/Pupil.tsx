/** What a pupil's page shows of the class: what the teacher wants, whether the work is kept, the hand, and "look up". */
import "./class.css";

import { type ReactNode, useEffect } from "react";
import { createPortal } from "react-dom";

import { Said } from "../../i18n/Said";
import { type Key, t } from "../../i18n/words";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { listen } from "../../ui/effects";
import { type MenuEntry, menuItem } from "../../ui/menu-model";
import { MenuButton } from "../../ui/MenuButton";
import { dismissOffer, type Offer, useOffers } from "./pupil-offers";
import { useClassroom } from "./classroom";
import { goAway, keepClass, letEdit, putHand } from "./pupil-sync";

const WORDS: Record<Offer["kind"], (words: string) => string> = {
  handed: (name) => t("class.sent", { name }),
  exercise: (name) => t("class.exercise-sent", { name }),
  comment: (words) => t("class.comment", { text: words }),
  note: (words) => t("class.note", { text: words }),
};

function OfferRow({ offer }: { offer: Offer }) {
  const { open } = offer;
  return (
    <div className="banner banner-note row rigid gap-xl" role="status" data-testid={`class-${offer.kind}`}>
      <Icon name={offer.open === null ? "message-circle" : "send"} size={18} />
      <p dir="auto">{WORDS[offer.kind](offer.words)}</p>
      {open === null ? null : (
        <Button
          onClick={() => {
            dismissOffer(offer);
            open();
          }}
        >
          {t("class.open")}
        </Button>
      )}
      <Button onClick={() => dismissOffer(offer)}>{t(open === null ? "class.read" : "class.later")}</Button>
    </div>
  );
}

/** Everything but STOP waits. */
const WAITS = ".head-menu, .toolbar, .middle, .bottom-bar, .sheet";

/** The page is covered: the teacher wants all to look up, or edits this mission. */
function Held({ icon, title, help, children }: { icon: string; title: string; help: string; children?: ReactNode }) {
  useEffect(() => {
    const all = [...document.querySelectorAll<HTMLElement>(WAITS)];
    for (const one of all) one.inert = true;
    const hold = (event: KeyboardEvent) => {
      const stops = event.key === "F5" && event.shiftKey;
      if (stops || (event.target instanceof Element && event.target.closest(".team-stop, .class-frozen") !== null))
        return;
      event.preventDefault();
      event.stopPropagation();
    };
    const endHolding = listen(window, { keydown: hold }, { capture: true });
    return () => {
      for (const one of all) one.inert = false;
      endHolding();
    };
  }, []);
  return createPortal(
    <div className="class-frozen centred" role="alert" data-testid="class-frozen">
      <div className="class-frozen-card surface text-centre">
        <Icon name={icon} size={40} />
        <h2>{title}</h2>
        <p>{help}</p>
        {children}
      </div>
    </div>,
    document.body,
  );
}

export function PupilBar() {
  const { news, connected } = useClassroom();
  const offers = useOffers((state) => state.offers);
  const frozen = news?.frozen === true;
  useEffect(keepClass, []);
  return (
    <>
      {offers.map((offer) => (
        <OfferRow key={offer.kind} offer={offer} />
      ))}
      {news?.turn === "asked" ? (
        <div className="banner banner-question row rigid gap-xl" role="alert" data-testid="class-turn">
          <Icon name="pencil" size={18} />
          <p>{t("class.asks-to-edit")}</p>
          <Button testId="class-let-edit" onClick={() => letEdit(true)}>
            {t("class.let-edit")}
          </Button>
          <Button onClick={() => letEdit(false)}>{t("class.not-edit")}</Button>
        </div>
      ) : null}
      {frozen ? <Held icon="snowflake" title={t("class.frozen")} help={t("class.frozen-help")} /> : null}
      {!frozen && connected && news?.turn === "teacher" ? (
        <Held icon="pencil" title={t("class.edits")} help={t("class.edits-help")}>
          <Button testId="class-take-back" onClick={() => letEdit(false)}>
            {t("class.take-back")}
          </Button>
        </Held>
      ) : null}
    </>
  );
}

const KEPT: Record<string, [Key, string]> = {
  yes: ["class.kept", "circle-check"],
  waits: ["class.keeping", "hourglass"],
  here: ["class.kept-here", "hard-drive"],
};

function KeptWords() {
  const { kept, problem, connected } = useClassroom();
  if (kept === "refused") {
    return (
      <span
        className="class-kept muted small-text rigid inline-row nowrap gap-s"
        role="status"
        data-testid="class-kept"
        data-kept="refused"
      >
        <Icon name="triangle-alert" size={16} />
        <Said text={t("class.not-kept", { why: problem })} />
      </span>
    );
  }
  const [words, icon] = KEPT[connected ? kept : "here"] ?? ["class.kept", "circle-check"];
  const away = words === "class.kept-here";
  return (
    <span
      className="class-kept muted small-text rigid inline-row nowrap gap-s"
      role="status"
      data-testid="class-kept"
      data-kept={connected ? kept : "here"}
      title={away ? t("class.kept-here-help") : t(words)}
    >
      <Icon name={icon} size={16} />
      <span>{t(words)}</span>
    </span>
  );
}

export function PupilKept() {
  const news = useClassroom((state) => state.news);
  const put = useClassroom((state) => state.hand);
  if (news === null) return <KeptWords />;
  const { name, class_name: of, word, looked } = news;
  const hand = put ?? news.hand;
  const entries: MenuEntry[] = [
    { kind: "heading", id: "class-word", label: t("class.you-word", { word: `${word.slice(0, 3)} ${word.slice(3)}` }) },
    menuItem("class-leave", t("class.leave"), null, goAway),
  ];
  const up = t(hand ? "class.hand-up" : "class.hand");
  return (
    <div className="class-pupil row rigid to-end gap-xs">
      <KeptWords />
      {looked ? (
        <span
          className="class-looked muted small-text rigid inline-row nowrap gap-s"
          role="status"
          title={t("class.looked")}
          data-testid="class-looked"
        >
          <Icon name="eye" size={16} label={t("class.looked")} />
        </span>
      ) : null}
      <button
        type="button"
        className="tool tool-named class-hand rigid nowrap medium gap-m relative"
        aria-pressed={hand}
        data-testid="class-hand"
        onClick={() => putHand(!hand)}
      >
        <Icon name="hand" size={18} />
        {up}
      </button>
      <MenuButton
        id="class-me"
        label={t("class.you", { name, class: of })}
        className="tool tool-named class-me rigid nowrap medium gap-m relative"
        entries={entries}
      >
        <Icon name="user-round" size={18} />
        <span dir="auto">{name}</span>
      </MenuButton>
    </div>
  );
}
