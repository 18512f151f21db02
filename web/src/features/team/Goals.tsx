/** What ends the mission as done: how many boxes a storehouse holds then, or all there are. */
import { NumberInput } from "../../components/fields/NumberInput";
import { readWhole } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { addGoal, ALL, changeGoal, removeGoal } from "../../model/commands/changeGoals";
import { execute, useStudio } from "../../model/studio";
import type { Goal } from "../../model/types";
import { Select } from "../../ui/Select";
import { RemoveTool, RowList, type RowProps } from "./RowList";

const MOST_BOXES = 65535;

function change(at: number, goal: Goal): void {
  execute(changeGoal(useStudio.getState().mission, at, goal));
}

function Row({ item: goal, at, removed }: RowProps<Goal>) {
  const world = useStudio((studio) => studio.world);
  const houses = world?.storehouses.map((house) => house.name) ?? [];
  const { storehouse, stock } = goal;
  const all = stock === ALL;
  return (
    <li className="team-row team-goal gap-m" data-testid={`goal-${String(at)}`}>
      <Select
        label={t("team.storehouse")}
        testId={`goal-house-${String(at)}`}
        value={storehouse}
        options={houses}
        missing={t("team.no-house", { house: storehouse })}
        wrong={world !== null && !houses.includes(storehouse)}
        keep={(house) => change(at, { ...goal, storehouse: house })}
      />
      <Select
        label={`${t("team.stock")}: ${storehouse}`}
        testId={`goal-all-${String(at)}`}
        value={all ? ALL : ""}
        options={[
          [ALL, t("team.all")],
          ["", t("team.number")],
        ]}
        keep={(wanted) => change(at, { ...goal, stock: wanted === ALL ? ALL : "1" })}
      />
      {all ? (
        <span />
      ) : (
        <NumberInput
          testId={`goal-stock-${String(at)}`}
          label={`${t("team.count")}: ${storehouse}`}
          min={0}
          max={MOST_BOXES}
          whole
          value={readWhole(stock) ?? 0}
          keep={(count) => change(at, { ...goal, stock: String(count) })}
        />
      )}
      <RemoveTool
        testId={`goal-remove-${String(at)}`}
        label={t("team.remove-goal", { house: storehouse })}
        onClick={() => {
          execute(removeGoal(useStudio.getState().mission, at));
          removed();
        }}
      />
    </li>
  );
}

export function Goals() {
  const goals = useStudio((studio) => studio.mission.goals);
  const houses = useStudio((studio) => studio.world?.storehouses);
  const none = houses === undefined || houses.length === 0;
  const first = houses?.find((house) => !goals.some((goal) => goal.storehouse === house.name)) ?? houses?.[0];
  return (
    <section className="team-part surface" aria-labelledby="team-goals">
      <h2 id="team-goals">{t("team.goals")}</h2>
      <p className="team-note muted">
        {goals.length > 0 ? t("team.goals-help") : none ? t("team.no-houses") : t("team.goals-none")}
      </p>
      <RowList
        items={goals}
        Row={Row}
        add={
          none && goals.length === 0
            ? null
            : {
                testId: "add-goal",
                label: t("team.add-goal"),
                can: first !== undefined,
                run: () => execute(addGoal(useStudio.getState().mission, first?.name ?? "")),
              }
        }
      />
    </section>
  );
}
