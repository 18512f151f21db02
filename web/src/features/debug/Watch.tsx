/**
 * Sensors and variables of an agent over time; variables can be set and sensors forced.
 *
 * Above the bottom bar, in the place of the list of problems. Left to others: what a run is (run), where it pauses.
 */
import "./watch.css";

import { useMemo, useState } from "react";

import { DockPanel } from "../../components/DockPanel";
import { numberTyped, within } from "../../components/fields/number-text";
import { t } from "../../i18n/words";
import { inWords, measureOf } from "../../model/meaning";
import type { Field } from "../../model/parts";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import type { RobotObject } from "../../model/types";
import { valueWords } from "../../model/words";
import { can, type RunAgent, useRun, watchedAgent } from "../../session/run";
import { Icon } from "../../theme";
import { Select } from "../../ui/Select";
import { EventList } from "./EventList";
import { Plot } from "./Plot";

export function WatchPanel() {
  const program = useStudio((state) => state.activeProgram);
  const agents = useRun((run) => run.agents);
  const chosen = useRun((run) => watchedAgent(run, program));
  const agent = chosen ?? agents[0];
  return (
    <DockPanel
      id="watch-panel"
      testId="watch"
      title={t("debug.watch")}
      close={t("debug.watch-close")}
      tools={
        <>
          {agents.length < 2 || agent === undefined ? null : (
            <Select
              className="watched small-text typed"
              label={t("debug.agent")}
              testId="watch-agent"
              value={agent.name}
              options={agents.map(({ name }) => name)}
              keep={(name) => {
                const found = agents.find((one) => one.name === name);
                if (found === undefined) return;
                useStudio.getState().setActiveProgram(found.program);
                useRun.getState().selectAgent(found.name, found.program);
              }}
            />
          )}
          <span className="grow" />
        </>
      }
    >
      {agent === undefined ? <p className="dock-none muted">{t("debug.watch-nothing")}</p> : <Values agent={agent} />}
    </DockPanel>
  );
}

function Values({ agent }: { agent: RunAgent }) {
  const robot = useStudio(({ catalogue }) => catalogue.robots.find((one) => one.name === agent.robot));
  const objects = robot?.objects ?? [];
  const sensors = objects.filter((object) => object.category === "sensor" && object.name in agent.inputs);
  const variables = objects.filter((object) => object.category === "variable" && object.name in agent.values);
  return (
    <div className="watch-columns dock-body wrap flex items-start">
      <Column title={t("parts.variables")} objects={variables} agent={agent} sensors={false} />
      <Column title={t("parts.sensors")} objects={sensors} agent={agent} sensors />
      <EventList />
    </div>
  );
}

function Column({
  title,
  objects,
  agent,
  sensors,
}: {
  title: string;
  objects: readonly RobotObject[];
  agent: RunAgent;
  sensors: boolean;
}) {
  if (objects.length === 0) return null;
  return (
    <table className="watch-table">
      <caption>{title}</caption>
      <thead className="only-spoken">
        <tr>
          <th scope="col">{t("debug.name")}</th>
          <th scope="col">{t("debug.value")}</th>
          <th scope="col">{t("debug.plot")}</th>
        </tr>
      </thead>
      <tbody>
        {objects.map((object) => (
          <Row key={object.name} object={object} agent={agent} sensor={sensors} />
        ))}
      </tbody>
    </table>
  );
}

function Row({ object, agent, sensor }: { object: RobotObject; agent: RunAgent; sensor: boolean }) {
  const { name } = object;
  const live = useRun((run) => can(sensor ? "force" : "set", run));
  const value = (sensor ? agent.inputs[name] : agent.values[name]) ?? 0;
  const forced = sensor && agent.forced.includes(name);
  const put = (wanted: number) => {
    const { force, setVariable } = useRun.getState();
    if (sensor) force(agent.name, name, wanted);
    else setVariable(agent.name, name, wanted);
  };
  const label = text(object.label, name);
  return (
    <tr data-testid={`watch-${name}`} data-forced={forced}>
      <th scope="row">{label}</th>
      <td className="watch-value">
        {object.type === "boolean" ? (
          <select
            className="field"
            aria-label={label}
            disabled={!live}
            value={value}
            onChange={(event) => put(event.target.value === "1" ? 1 : 0)}
          >
            <option value={1}>{valueWords(object, 1)}</option>
            <option value={0}>{valueWords(object, 0)}</option>
          </select>
        ) : (
          <NumberCell key={agent.name} label={label} value={value} object={object} live={live} put={put} />
        )}
      </td>
      <td>
        <Plot agent={agent.name} object={object} label={label} value={value} />
      </td>
      <td className="watch-force">
        {/* Where nothing is held the button keeps its room, so that holding a sensor moves nothing. */}
        {sensor ? (
          <button
            type="button"
            className={forced ? "tool small" : "tool small is-room"}
            data-testid={forced ? `release-${name}` : undefined}
            aria-label={`${t("debug.release")}: ${label}`}
            title={t("debug.release-help")}
            onClick={() => useRun.getState().force(agent.name, name, null)}
          >
            <Icon name="hand" size={16} />
          </button>
        ) : null}
      </td>
    </tr>
  );
}

/** Shows the value; while it has the focus, what is typed. */
function NumberCell({
  label,
  value,
  object,
  live,
  put,
}: {
  label: string;
  value: number;
  object: RobotObject;
  live: boolean;
  put: (value: number) => void;
}) {
  const [typed, setTyped] = useState<string | null>(null);
  const field = useMemo(() => fieldOf(object), [object]);
  const wanted = typed === null ? null : numberTyped(typed, field);
  const wrong = typed !== null && (wanted === null || within(wanted, field) !== wanted);
  const keep = () => {
    if (wanted !== null && !wrong && wanted !== value) put(wanted);
    setTyped(null);
  };
  return (
    <input
      className="field"
      type="text"
      inputMode="numeric"
      size={7}
      aria-label={label}
      aria-invalid={wrong}
      title={`${inWords(field, object.min)} … ${inWords(field, object.max)}`}
      disabled={!live}
      value={typed ?? inWords(field, value)}
      onFocus={(event) => {
        setTyped(inWords(field, value));
        event.target.select();
      }}
      onChange={(event) => setTyped(event.target.value)}
      onBlur={keep}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Enter") {
          event.currentTarget.blur();
        } else if (event.key === "Escape") {
          setTyped(null);
        }
      }}
    />
  );
}

/** A sensor or variable as something that is typed in. */
function fieldOf({ name, label, help, min, max, unit = "", meaning = null }: RobotObject): Field {
  const measure = measureOf({ unit, meaning }, null);
  return { name, label, help, kind: "integer", min, max, default: "0", ...measure };
}
