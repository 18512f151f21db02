/** What ends the mission as done: how many boxes a storehouse holds then, or all there are. */
import { useRef } from "react";

import type { Command } from "../model/command";
import { addGoal, ALL, changeGoal, removeGoal } from "../model/commands/changeGoals";
import { useStudio } from "../model/studio";
import type { Goal } from "../model/types";
import { Icon } from "../theme";
import { t } from "../words/words";

const MOST_BOXES = 65535;

function execute(command: Command | null): void {
  if (command !== null) useStudio.getState().execute(command);
}

function change(at: number, goal: Goal): void {
  execute(changeGoal(useStudio.getState().mission, at, goal));
}

function Row({ goal, at, removed }: { goal: Goal; at: number; removed: () => void }) {
  const world = useStudio((studio) => studio.world);
  const houses = world?.storehouses.map((house) => house.name) ?? [];
  const { storehouse, stock } = goal;
  const lost = world !== null && !houses.includes(storehouse);
  const name = t("team.remove-goal", { house: storehouse });
  const all = stock === ALL;
  return (
    <li className="team-row team-goal" data-testid={`goal-${String(at)}`}>
      <select
        className="field"
        data-testid={`goal-house-${String(at)}`}
        aria-label={t("team.storehouse")}
        aria-invalid={lost}
        value={storehouse}
        onChange={(event) => change(at, { ...goal, storehouse: event.target.value })}
      >
        {houses.includes(storehouse) ? null : (
          <option value={storehouse}>{t("team.no-house", { house: storehouse })}</option>
        )}
        {houses.map((house) => (
          <option key={house}>{house}</option>
        ))}
      </select>
      <select
        className="field"
        data-testid={`goal-all-${String(at)}`}
        aria-label={`${t("team.stock")}: ${storehouse}`}
        value={all ? ALL : ""}
        onChange={(event) => change(at, { ...goal, stock: event.target.value === ALL ? ALL : "1" })}
      >
        <option value={ALL}>{t("team.all")}</option>
        <option value="">{t("team.number")}</option>
      </select>
      {all ? (
        <span />
      ) : (
        <input
          className="field"
          type="number"
          min="0"
          max={MOST_BOXES}
          step="1"
          data-testid={`goal-stock-${String(at)}`}
          aria-label={`${t("team.count")}: ${storehouse}`}
          value={stock}
          onChange={(event) => {
            const digits = /^\d{1,5}$/.exec(event.target.value)?.[0];
            if (digits !== undefined) change(at, { ...goal, stock: String(Math.min(Number(digits), MOST_BOXES)) });
          }}
        />
      )}
      <span className="team-tools">
        <button
          type="button"
          className="tool small"
          data-what="remove"
          data-testid={`goal-remove-${String(at)}`}
          aria-label={name}
          title={name}
          onClick={() => {
            execute(removeGoal(useStudio.getState().mission, at));
            removed();
          }}
        >
          <Icon name="trash-2" size={16} />
        </button>
      </span>
    </li>
  );
}

export function Goals() {
  const goals = useStudio((studio) => studio.mission.goals);
  const houses = useStudio((studio) => studio.world?.storehouses);
  const button = useRef<HTMLButtonElement>(null);
  const list = useRef<HTMLUListElement>(null);
  const none = houses === undefined || houses.length === 0;
  const first = houses?.find((house) => !goals.some((goal) => goal.storehouse === house.name)) ?? houses?.[0];
  return (
    <section className="team-part" aria-labelledby="team-goals">
      <h2 id="team-goals">{t("team.goals")}</h2>
      <p className="team-note">
        {goals.length > 0 ? t("team.goals-help") : none ? t("team.no-houses") : t("team.goals-none")}
      </p>
      {goals.length === 0 ? null : (
        <ul ref={list}>
          {goals.map((goal, at) => (
            <Row key={at} goal={goal} at={at} removed={() => requestAnimationFrame(() => button.current?.focus())} />
          ))}
        </ul>
      )}
      {none && goals.length === 0 ? null : (
        <button
          type="button"
          className="button"
          ref={button}
          data-testid="add-goal"
          disabled={first === undefined}
          onClick={() => {
            execute(addGoal(useStudio.getState().mission, first?.name ?? ""));
            requestAnimationFrame(() => list.current?.lastElementChild?.querySelector<HTMLElement>("select")?.focus());
          }}
        >
          <Icon name="plus" size={16} /> {t("team.add-goal")}
        </button>
      )}
    </section>
  );
}
