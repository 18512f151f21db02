/**
 * Who is in which role and group at the moment that the run stands at, since when and why; where members wait for each
 * other; and each change so far, which a click goes to.
 */
import { useMemo } from "react";

import { DockPanel } from "../../components/DockPanel";
import { StateShape } from "../../components/StateShape";
import { clock } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { changesOf, MEMBERS } from "../../session/members";
import { meetingSaid } from "../../session/meetings";
import { can, useRun } from "../../session/run";
import "./members.css";

const SHOWN = 100;

function Moment({ tick }: { tick: number }) {
  const tickMs = useRun((run) => run.tickMs);
  const goes = useRun((run) => can("seek", run));
  const time = clock((tick * tickMs) / 1000);
  return (
    <button
      type="button"
      className="moment finger"
      disabled={!goes}
      title={t("members.go", { time })}
      onClick={() => useRun.getState().seek(tick)}
    >
      {time}
    </button>
  );
}

export function Members() {
  const team = useRun((run) => run.team);
  const agents = useRun((run) => run.agents);
  const events = useRun((run) => run.events);
  const tick = useRun((run) => run.tick);
  const changes = useMemo(() => changesOf(events).filter((event) => event.tick <= tick), [events, tick]);
  if (team === null) return null;
  const waits = team.meetings.filter((one) => one.missing.length > 0);
  return (
    <DockPanel id={MEMBERS} testId="members" title={t("members.title")} close={t("members.close")}>
      <div className="members-columns dock-body wrap flex items-start">
        <table className="members-table panel-title" data-testid="members-table">
          <thead>
            <tr>
              <th scope="col">{t("members.who")}</th>
              <th scope="col">{t("members.role")}</th>
              <th scope="col">{t("members.groups")}</th>
              <th scope="col">{t("members.since")}</th>
              <th scope="col">{t("members.why")}</th>
            </tr>
          </thead>
          <tbody>
            {team.members.map(({ name, role, groups, stands_for, missed }) => {
              const last = changes.findLast((event) => event.agent === name);
              const state = agents.find((one) => one.name === name)?.state ?? "idle";
              return (
                <tr key={name} data-testid={`member-row-${name}`}>
                  <th scope="row" className="bold">
                    <StateShape state={state} /> <bdi>{name}</bdi>
                  </th>
                  <td>
                    {role === "" ? (
                      <span className="muted">{t(missed ? "members.missed" : "members.spare")}</span>
                    ) : stands_for === name || stands_for === "" ? (
                      <bdi>{role}</bdi>
                    ) : (
                      t("members.for", { role, name: stands_for })
                    )}
                  </td>
                  <td>{groups.join(", ")}</td>
                  <td>
                    <Moment tick={last?.tick ?? 0} />
                  </td>
                  <td>{last === undefined ? t("members.began") : <Said text={last.text} />}</td>
                </tr>
              );
            })}
          </tbody>
        </table>
        <div>
          {waits.map((meeting) => (
            <p key={meeting.point} className="members-wait bold below">
              {meetingSaid(meeting)}
            </p>
          ))}
          {changes.length === 0 ? (
            <p className="muted">{t("members.unchanged")}</p>
          ) : (
            <ol
              className="members-changes column gap-xs"
              aria-label={t("members.changes")}
              data-testid="members-changes"
            >
              {changes
                .slice(-SHOWN)
                .reverse()
                .map((event, index) => (
                  <li key={index}>
                    <Moment tick={event.tick} /> <strong dir="auto">{event.agent}</strong> <Said text={event.text} />
                  </li>
                ))}
            </ol>
          )}
        </div>
      </div>
    </DockPanel>
  );
}
