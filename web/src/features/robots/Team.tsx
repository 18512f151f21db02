/** The team in the panel of robots: a body for each agent, sending to all boards, starting all agents as processes. */
import "./team.css";

import { useEffect, useId } from "react";

import type { AgentActivity } from "../../api/wire";
import { StateShape } from "../../components/StateShape";
import { Said } from "../../i18n/Said";
import { type Key, t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { stopEverything } from "../../session/features";
import { Select } from "../../ui/Select";
import { useBoards } from "./boards";
import { Act, Sending, TroubleBox, WayOut } from "./parts";
import { keepShown } from "./board-run";
import { showRobots } from "./state";
import {
  bodyOf,
  cancelTeam,
  chooseBody,
  isBusy,
  MOST_AGENTS,
  placesFor,
  sendToAll,
  standingOf,
  startTeam,
  TEAM,
} from "./team";
import type { Team, TeamAgent } from "./wire";

const SHAPES: Record<TeamAgent["state"], AgentActivity> = {
  idle: "idle",
  sending: "waiting",
  sent: "idle",
  starting: "waiting",
  there: "running",
  ended: "stalled",
};

/** What an agent does, in a word; "" where there is nothing to say. */
function stateWords(standing: TeamAgent | undefined): string {
  if (standing === undefined) return "";
  if (standing.failed) return t("crew.state-failed");
  return standing.state === "idle" ? "" : t(`crew.state-${standing.state}`);
}

/** What it said last, or what went wrong with it. */
function Message({ standing }: { standing: TeamAgent }) {
  if (standing.message === "") return null;
  if (!standing.failed)
    return (
      <p className="crew-said muted small-text">
        <Said text={standing.message} />
      </p>
    );
  return (
    <TroubleBox said={standing} testId="crew-trouble">
      <WayOut way={standing.way} of="crew" onPress={(way) => sendToAll({ [standing.name]: way })} />
    </TroubleBox>
  );
}

function Member({ name, disabled }: { name: string; disabled: boolean }) {
  const state = useBoards();
  const path = useStudio(({ file }) => file.path);
  const standing = standingOf(state.team, path, name);
  const chosen = bodyOf(state, path, name);
  const label = useId();
  return (
    <li className="crew-member" data-testid="crew-member" data-agent={name} data-state={standing?.state ?? "idle"}>
      <div className="crew-row gap-m">
        <StateShape state={standing?.failed === true ? "failed" : SHAPES[standing?.state ?? "idle"]} size={10} />
        <span className="ellipsis medium" id={label}>
          {name}
        </span>
        <Select
          className="field small-field"
          label={t("crew.body", { name })}
          testId="crew-body"
          disabled={disabled}
          value={chosen}
          options={[
            ["", t("crew.simulated")],
            ...placesFor(state, chosen).map(({ address, name: place }): [string, string] => [
              address,
              address.endsWith(place) ? place : `${place} (${address})`,
            ]),
          ]}
          keep={(address) => chooseBody(name, address)}
        />
        <span className="muted small-text">{stateWords(standing)}</span>
      </div>
      {standing?.state === "sending" ? <Sending progress={standing.progress} testId="crew-progress" /> : null}
      {standing === undefined ? null : <Message standing={standing} />}
    </li>
  );
}

/** What the team does, and what was refused to it. */
function Status({ team, other }: { team: Team | null; other: boolean }) {
  const refused = useBoards((state) => state.refused[TEAM]);
  const trouble = refused ?? (team?.failed === true && !other ? team : null);
  const phase: Key | null = team === null || team.phase === "idle" ? null : `crew.phase-${team.phase}`;
  return (
    <>
      <p
        className="crew-status muted small-text wrap flex below"
        role="status"
        data-testid="crew-status"
        data-phase={team?.phase ?? "idle"}
      >
        {phase === null ? null : <strong>{t(phase)}</strong>}
        {other && phase !== null ? <span>{t("crew.other", { mission: team?.path ?? "" })}</span> : null}
        {trouble === null && team !== null && !other && team.message !== "" ? <Said text={team.message} /> : null}
      </p>
      {trouble === null ? null : <TroubleBox said={trouble} testId="crew-refused" />}
    </>
  );
}

function Acts({ team, boards, ready }: { team: Team | null; boards: number; ready: boolean }) {
  const busy = isBusy(team);
  if (busy && team?.phase !== "sending")
    return (
      <div className="robot-acts row wrap slim">
        <Act ink icon="square" label={t("crew.stop")} testId="crew-stop" onPress={stopEverything} />
        <Act icon="eye" label={t("crew.watch")} testId="crew-watch" onPress={() => showRobots(false)} />
      </div>
    );
  return (
    <div className="robot-acts row wrap slim">
      {busy ? <Act icon="x" label={t("boards.cancel")} testId="crew-cancel" onPress={cancelTeam} /> : null}
      <Act
        ink
        icon="play"
        label={t("crew.start")}
        testId="crew-start"
        title={t("crew.start-help")}
        disabled={busy || !ready}
        onPress={startTeam}
      />
      <Act
        icon="upload"
        label={t("crew.send")}
        testId="crew-send"
        title={t("crew.send-help")}
        disabled={busy || !ready || boards === 0}
        onPress={() => sendToAll()}
      />
    </div>
  );
}

export function TeamPart() {
  const agents = useStudio(({ mission }) => mission.agents);
  const path = useStudio(({ file }) => file.path);
  const state = useBoards();
  const title = useId();
  useEffect(keepShown, []);
  if (agents.length < 2) return null;
  const { team, you } = state;
  const other = isBusy(team) && team?.path !== path;
  const tooMany = agents.length > MOST_AGENTS;
  const boards = agents.filter(({ name }) => bodyOf(state, path, name) !== "").length;
  return (
    <section className="crew boxed" data-testid="crew" aria-labelledby={title}>
      <h3 id={title} className="panel-title">
        {t("crew.title")}
      </h3>
      <p className="robots-note muted">
        {tooMany ? t("crew.too-many", { most: MOST_AGENTS, count: agents.length }) : t("crew.about")}
      </p>
      <Status team={team} other={other} />
      <Acts team={team} boards={boards} ready={you !== "" && !tooMany} />
      {tooMany ? null : (
        <ul className="crew-list gap-xs">
          {agents.map(({ name }) => (
            <Member key={name} name={name} disabled={isBusy(team)} />
          ))}
        </ul>
      )}
    </section>
  );
}
