/**
 * The panel of real robots, in the place of the arena: what is plugged in or on the network, what runs there, and what to do
 * where nothing is.
 *
 * Left to others: one robot (`BoardCard`), what is done (`acts`). Ports are looked for only while this stands here.
 */
import "./boards.css";

import { type FormEvent, useEffect, useState } from "react";

import { inPage } from "../../api/transport";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { stopEverything } from "../../session/features";
import { Button } from "../../ui/Button";
import { Tool } from "../../ui/Tool";
import { addAddress, runOnAll } from "./actions";
import { BoardCard } from "./BoardCard";
import { BoardFileSheet } from "./BoardFileSheet";
import { isMine, MOST_ADDRESS, placesOf, useBoards } from "./boards";
import { FirmwarePart } from "./Firmware";
import { KitAtHand } from "./KitAtHand";
import { KitSheet } from "./KitSheet";
import { findBoard, reach } from "./serial";
import { connect, send } from "./socket";
import { showRobots } from "./state";
import { TeamPart } from "./Team";

function useLooking(): void {
  const { you } = useBoards();
  useEffect(connect, []);
  useEffect(() => {
    if (you === "") return;
    send({ type: "look", on: true });
    return () => {
      if (useBoards.getState().you === you) send({ type: "look", on: false });
    };
  }, [you]);
}

function Barred() {
  const barred = useBoards((state) => state.barred);
  if (barred === null) return null;
  return (
    <div className="robot-trouble notice flex below items-start" role="alert" data-testid="robots-barred">
      <p className="grow">
        <strong>
          <Said text={barred.message} />
        </strong>{" "}
        <Said text={barred.help} />
      </p>
      <Button icon="refresh-cw" onClick={connect}>
        {t("boards.again")}
      </Button>
    </div>
  );
}

function Network() {
  const [text, setText] = useState("");
  const [wrong, setWrong] = useState(false);
  const add = (event: FormEvent) => {
    event.preventDefault();
    const added = addAddress(text);
    setWrong(!added);
    if (added) setText("");
  };
  return (
    <form className="robots-network" onSubmit={add} noValidate>
      <label htmlFor="robots-address">{t("boards.network")}</label>
      <input
        className="field small-field code-text"
        id="robots-address"
        data-testid="robots-address"
        dir="ltr"
        placeholder="socket://192.168.4.1:4000"
        value={text}
        maxLength={MOST_ADDRESS}
        autoComplete="off"
        spellCheck={false}
        aria-invalid={wrong}
        aria-describedby={wrong ? "robots-address-wrong" : undefined}
        onChange={(event) => {
          setText(event.target.value);
          setWrong(false);
        }}
      />
      <Button type="submit" testId="robots-add" disabled={text.trim() === ""}>
        {t("boards.connect")}
      </Button>
      {wrong ? (
        <p className="robots-wrong muted small-text" id="robots-address-wrong" role="alert">
          {t("boards.network-wrong")}
        </p>
      ) : null}
    </form>
  );
}

/** For several robots at once. */
function Together() {
  const state = useBoards();
  const mine = placesOf(state).filter(({ board }) => board !== null && isMine(state, board));
  const running = Object.values(state.boards).some(({ state: now }) => now === "running");
  if (Object.keys(state.boards).length < 2) return null;
  return (
    <>
      <Button
        icon="play"
        iconSize={14}

        testId="robots-run-all"
        disabled={mine.length < 2}
        onClick={runOnAll}
      >
        {t("boards.run-all")}
      </Button>
      <Button
        icon="square"
        iconSize={14}

        testId="robots-stop-all"
        disabled={!running}
        onClick={stopEverything}
      >
        {t("boards.stop-all")}
      </Button>
    </>
  );
}

/** The robots, and the ways to get more of them; drawn together, so that none moves away from under a pointer. */
function Places() {
  const state = useBoards();
  const places = placesOf(state);
  return (
    <>
      {places.length > 0 ? (
        <ul className="robots-list gap-m">
          {places.map((place) => (
            <BoardCard key={place.address} place={place} />
          ))}
        </ul>
      ) : state.ports === null || (inPage() && reach() !== "there") ? null : (
        <>
          <EmptyRobots />
          <KitAtHand />
        </>
      )}
      <FindBoard />
      {inPage() ? (
        <p className="robots-note muted" data-testid="robots-in-page">
          {t("boards.in-page")}
        </p>
      ) : (
        <>
          <Network />
          <FirmwarePart />
        </>
      )}
    </>
  );
}

export function Robots() {
  useLooking();
  const looking = useBoards((state) => state.ports === null && state.barred === null && placesOf(state).length === 0);
  return (
    <section className="robots column" data-testid="robots" aria-label={t("boards.title")}>
      <header className="robots-head row rigid panel-head">
        <h2 className="panel-title">{t("boards.title")}</h2>
        <span className="grow" />
        <Together />
        <Tool small icon="x" label={t("boards.close")} testId="robots-close" onClick={() => showRobots(false)} />
      </header>
      <KitSheet />
      <BoardFileSheet />
      <div className="dock-body fill">
        <Barred />
        {inPage() ? null : <TeamPart />}
        {looking ? <p className="robots-note muted">{t("boards.looking")}</p> : <Places />}
      </div>
    </section>
  );
}

/** A button with which the reader lets the page use a board of this computer; where it cannot, why, and what can. */
export function FindBoard() {
  const you = useBoards((state) => state.you);
  if (you === "") return null;
  const now = reach();
  if (now !== "there") {
    return (
      <p className="robots-note muted" data-testid="find-board-not">
        {t(now === "none" ? "boards.find-none" : "boards.find-unsafe")}
      </p>
    );
  }
  return (
    <div className="robots-find row wrap">
      <Button icon="radio" testId="find-board" onClick={() => void findBoard()}>
        {t("boards.find")}
      </Button>
      <span className="robots-note muted">{t("boards.find-help")}</span>
    </div>
  );
}

type System = "linux" | "windows" | "other";

/** The kind of computer that this page is on. */
export function systemOf(userAgent: string): System {
  if (/windows/i.test(userAgent)) return "windows";
  return /linux|cros|x11/i.test(userAgent) && !/android/i.test(userAgent) ? "linux" : "other";
}

/** What the panel says where no robot is: how one gets there, and what this kind of computer may want first. */
export function EmptyRobots() {
  const system = systemOf(navigator.userAgent);
  return (
    <div className="robots-empty" data-testid="robots-empty">
      <h3>{t("boards.none")}</h3>
      <ol>
        <li>{t("boards.none-plug")}</li>
        <li>{t(inPage() ? "boards.none-choose" : "boards.none-appears")}</li>
      </ol>
      <details>
        <summary>{t("boards.none-trouble")}</summary>
        {system === "linux" ? (
          <>
            <p>{t("boards.none-linux")}</p>
            <pre dir="ltr">sudo usermod -aG dialout $USER</pre>
          </>
        ) : null}
        {system === "windows" ? <p>{t("boards.none-windows")}</p> : null}
        <p>{t("boards.none-cable")}</p>
      </details>
    </div>
  );
}
