/** One robot in the panel: where it is, which program goes there, what it does, and all that can be done with it. */
import { useId } from "react";

import { StateShape } from "../../components/StateShape";
import { grouped } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { showFirstProblem } from "../../session/problem-walk";
import { Icon } from "../../theme";
import { Row } from "../../ui/Row";
import { Select } from "../../ui/Select";
import { Tool } from "../../ui/Tool";
import {
  beginBench,
  cancelSending,
  connectBoard,
  disconnectBoard,
  goToFault,
  identify,
  isCurrent,
  removeAddress,
  runOn,
  sendTo,
  stopBoard,
  watchBoard,
} from "./actions";
import { chooseProgram, isMine, type Place, programFor, useBoards } from "./boards";
import { KitChoice } from "./KitChoice";
import { Act, Sending, TroubleBox, WayOut } from "./parts";
import { playRecording, saveRecording } from "./recording";
import { dropBoard } from "./serial";
import { TryParts } from "./TryParts";
import type { Board } from "./wire";

const SHAPES = { none: "idle", ready: "idle", running: "running", ended: "idle", fault: "failed" } as const;

/** A number that keeps its order of digits in a script that runs the other way. */
function isolated(number: string): string {
  return `\u2066${number}\u2069`;
}

/** What it does, in a word. */
function stateWords(board: Board | null): string {
  if (board === null || board.phase === "closed") return t("boards.state-closed");
  if (board.phase === "open") {
    if (board.state === "running") return t(board.held ? "boards.state-held" : "boards.state-free");
    return t(`boards.state-${board.state}`);
  }
  return t(`boards.state-${board.phase}`);
}

/** State, program on it, memory. */
function Stands({ board }: { board: Board | null }) {
  if (board === null) {
    // Its line is there before anything is known, so that what comes moves nothing.
    return (
      <p className="robot-stands wrap muted small-text flex below">
        <span>{stateWords(board)}</span>
      </p>
    );
  }
  const open = board.phase === "open";
  const named = board.program !== "" || board.installed === "" || board.installed === "-";
  return (
    <p
      className="robot-stands wrap muted small-text flex below"
      data-testid="robot-state"
      data-phase={board.phase}
      data-state={board.state}
    >
      <span role="status">{stateWords(board)}</span>
      {open && board.program !== "" ? <span>{board.program}</span> : null}
      {open && !named ? <span>{t("boards.other-program")}</span> : null}
      {open ? <span>{t("boards.free", { bytes: isolated(grouped(board.free)) })}</span> : null}
      {open && board.micropython !== "" ? (
        <span data-testid="robot-micropython" dir="ltr">
          MicroPython {board.micropython}
        </span>
      ) : null}
    </p>
  );
}

function Fault({ board }: { board: Board }) {
  const { fault } = board;
  if (fault === null) return null;
  const place = fault.line > 0 ? t("boards.fault-line", { line: fault.line }) : "";
  return (
    <div className="robot-trouble notice flex below items-start" role="alert" data-testid="robot-fault">
      <Icon name="octagon-x" size={16} />
      <p className="grow">
        <strong>
          {t("boards.fault", { number: fault.number })} <Said text={fault.sentence} />
        </strong>
        {fault.text === "" ? null : <code className="block code-text">{fault.text}</code>}
        {fault.vertex === "" ? null : (
          <button
            type="button"
            className="robot-link start-text medium"
            data-testid="robot-fault-vertex"
            onClick={() => goToFault(board.address)}
          >
            {t("boards.fault-where", { program: fault.program, place })}
          </button>
        )}
      </p>
    </div>
  );
}

/** What went wrong with the link or the sending, in the server's words. */
function Trouble({ place: { address, board, firmware } }: { place: Place }) {
  const refused = useBoards((state) => state.refused[address]);
  const said = refused ?? (board !== null && board.message !== "" ? { ...board, problems: [] } : null);
  if (said === null) return null;
  const [first] = said.problems;
  return (
    <TroubleBox said={said} testId="robot-trouble">
      {first === undefined ? null : (
        <button
          type="button"
          className="robot-link start-text medium"
          data-testid="robot-problems"
          onClick={showFirstProblem}
        >
          {t("boards.problems", { count: said.problems.length })}
        </button>
      )}
      {firmware !== "" && refused === undefined && board?.phase === "closed" ? (
        <a
          className="robot-link start-text medium"
          href={firmware}
          target="_blank"
          rel="noreferrer"
          data-testid="robot-firmware"
        >
          {t("boards.firmware")}
        </a>
      ) : null}
      {refused !== undefined || board === null ? null : (
        <WayOut way={board.way} of="robot" onPress={(way) => sendTo(address, "ready", way)} />
      )}
    </TroubleBox>
  );
}

function Program({ address, disabled }: { address: string; disabled: boolean }) {
  const programs = useStudio((studio) => studio.mission.programs);
  const open = useStudio((studio) => studio.activeProgram);
  const state = useBoards();
  const names = programs.map(({ name }) => name);
  return (
    <Row label={t("boards.program")} className="robot-program muted below">
      <Select
        className="field small-field"
        label={t("boards.program")}
        testId="robot-program"
        disabled={disabled}
        value={programFor(state, address, names, open)}
        options={names}
        keep={(program) => chooseProgram(address, program)}
      />
    </Row>
  );
}

function Acts({ place: { address, board }, title }: { place: Place; title: string }) {
  // What is drawn changes whether the robot has it.
  useStudio(({ mission }) => mission);
  const current = isCurrent(address);
  const running = board?.phase === "open" && board.state === "running";
  const open = board?.phase === "open";
  if (board?.phase === "sending") return null;
  // While it is greeted they keep their place, and wait.
  return (
    <fieldset className="robot-acts row wrap slim" disabled={board?.phase === "connecting"} aria-labelledby={title}>
      {board?.phase === "lost" ? (
        <Act
          ink
          icon="refresh-cw"
          label={t("boards.reconnect")}
          testId="robot-reconnect"
          onPress={() => connectBoard(address)}
        />
      ) : null}
      {running ? (
        <Act ink icon="square" label={t("boards.stop")} testId="robot-stop" onPress={() => stopBoard(address)} />
      ) : (
        <Act
          ink={board?.phase !== "lost"}
          icon="play"
          label={t("boards.run")}
          testId="robot-run"
          title={t(current ? "boards.run-again-help" : "boards.run-help")}
          onPress={() => runOn(address)}
        />
      )}
      {board === null || board.phase === "closed" || board.phase === "connecting" ? (
        <Act icon="radio" label={t("boards.connect")} testId="robot-connect" onPress={() => connectBoard(address)} />
      ) : null}
      {!running ? (
        <Act
          icon="upload"
          label={t("boards.send")}
          testId="robot-send"
          title={t("boards.send-help")}
          onPress={() => sendTo(address, "ready")}
        />
      ) : null}
      {open && !(running && !board.held) ? (
        <Act
          icon="log-out"
          label={t("boards.let-go")}
          testId="robot-free"
          title={t("boards.let-go-help")}
          onPress={() => runOn(address, false)}
        />
      ) : null}
      {!running ? (
        <Act
          icon="wrench"
          label={t("boards.try")}
          testId="robot-try"
          title={t("boards.try-help")}
          onPress={() => beginBench(address)}
        />
      ) : null}
      {running && board.program !== "" ? (
        <Act icon="eye" label={t("debug.watch")} testId="robot-watch" onPress={() => watchBoard(address)} />
      ) : null}
    </fieldset>
  );
}

/** What its last run left behind, or the one that is on so far. */
function Recorded({ board }: { board: Board | null }) {
  if (board?.recorded !== true || board.phase === "sending") return null;
  return (
    <div className="robot-acts robot-recorded row wrap slim" data-testid="robot-recorded">
      <Act
        icon="clapperboard"
        label={t("boards.play-recording")}
        testId="robot-play-recording"
        title={t("boards.play-recording-help")}
        onPress={() => void playRecording(board)}
      />
      <Act
        icon="file"
        label={t("boards.save-recording")}
        testId="robot-save-recording"
        title={t("boards.save-recording-help")}
        onPress={() => void saveRecording(board)}
      />
    </div>
  );
}

export function BoardCard({ place }: { place: Place }) {
  const { address, name, description, board } = place;
  const mine = useBoards((state) => isMine(state, board));
  const typed = useBoards((state) => state.typed.includes(address));
  const steps = useBoards((state) => state.steps[address]);
  const trying = steps !== undefined && board !== null && board.phase === "open" && board.bench !== null;
  const title = useId();
  const atPage = address.startsWith("page:");
  const open = board?.phase === "open";
  const state = board === null || board.phase !== "open" ? "idle" : SHAPES[board.state];
  return (
    <li className="robot boxed" data-testid="robot" data-address={address} aria-labelledby={title}>
      <div className="row">
        <StateShape state={board?.phase === "lost" ? "stalled" : state} size={10} />
        <h3 id={title} className="panel-title ellipsis">
          {name}
        </h3>
        {atPage ? (
          <span className="robots-note muted" data-testid="robot-at-page">
            {t("boards.at-page")}
          </span>
        ) : address.endsWith(name) ? null : (
          <span className="ellipsis muted code-text" dir="ltr" title={description}>
            {address}
          </span>
        )}
        <span className="grow" />
        {open && mine ? (
          <Tool
            small
            icon="lightbulb"
            label={t("boards.identify", { name })}
            testId="robot-identify"
            onClick={() => identify(address)}
          />
        ) : null}
        {board !== null && mine ? (
          <Tool
            small
            icon="power-off"
            label={t("boards.disconnect", { name })}
            testId="robot-disconnect"
            onClick={() => disconnectBoard(address)}
          />
        ) : null}
        {board === null && (typed || atPage) ? (
          <Tool
            small
            icon="trash-2"
            label={t("boards.remove", { name })}
            testId="robot-remove"
            onClick={() => (atPage ? dropBoard(address) : removeAddress(address))}
          />
        ) : null}
      </div>
      <Stands board={board} />
      {board?.phase === "sending" ? (
        <Sending progress={board.progress} testId="robot-progress">
          <Act icon="x" label={t("boards.cancel")} testId="robot-cancel" onPress={() => cancelSending(address)} />
        </Sending>
      ) : null}
      {board === null ? null : <Fault board={board} />}
      <Trouble place={place} />
      {mine ? (
        <>
          <Program address={address} disabled={board?.phase === "sending"} />
          <KitChoice
            address={address}
            disabled={board?.phase === "sending"}
            has={board?.micropython ?? ""}
            page={place.firmware}
          />
          {board !== null && trying ? <TryParts board={board} /> : <Acts place={place} title={title} />}
          <Recorded board={board} />
        </>
      ) : (
        <div className="robot-acts row wrap slim">
          <span className="robots-note muted">{t("boards.another-page")}</span>
          <Act ink icon="square" label={t("boards.stop")} testId="robot-stop" onPress={() => stopBoard(address)} />
        </div>
      )}
    </li>
  );
}
