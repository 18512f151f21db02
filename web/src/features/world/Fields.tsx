/** The numbers and names of what is chosen; of the world itself when nothing is. */
import { NameCell } from "../../components/NameCell";
import { handKey } from "../../i18n/touch";
import { type Key, sentence, t } from "../../i18n/words";
import { changeOwnWorld, isFreeName, isNamed, renameThing } from "../../model/commands/changeOwnWorld";
import { execute, useStudio } from "../../model/studio";
import type { OwnWorld } from "../../model/types";
import { kindName } from "../../model/world/names";
import { LARGEST_MM, partOf, isSamePart, thingNamed, tidy } from "../../model/world/part-reference";
import { duplicateChosen, removeChosen } from "../../session/world-edits";
import { chosenIn, useWorld } from "../../session/world-view";
import { Icon } from "../../theme";
import { Tool } from "../../ui/Tool";
import { NumberField } from "./NumberField";
import { PartFields } from "./PartFields";

function WorldItself({ world }: { world: OwnWorld }) {
  const keep = (more: Partial<OwnWorld>, stepped = false) =>
    execute(
      changeOwnWorld(
        useStudio.getState().mission,
        t("command.world"),
        { ...world, ...more },
        stepped ? `world ${Object.keys(more).join(" ")}` : undefined,
      ),
    );
  return (
    <section className="world-chosen column gap-m" aria-labelledby="world-itself">
      <h2 id="world-itself">{t("world.tab")}</h2>
      <NameCell
        name={world.name}
        label={t("world.name")}
        testId="world-name"
        wrong={(name) => (name === "" ? t("world.name-empty") : "")}
        keep={(name) => keep({ name })}
      />
      <div className="world-fields gap-m">
        {(["width_mm", "height_mm"] as const).map((name) => (
          <NumberField
            key={name}
            label={t(`world.${name}` as Key)}
            value={world[name]}
            min={1}
            max={LARGEST_MM}
            step={100}
            testId={`world-${name}`}
            keep={(value, stepped) => keep({ [name]: tidy(value) }, stepped)}
          />
        ))}
      </div>
      <p className="muted small-text">{t(handKey("world.hint"))}</p>
    </section>
  );
}

export function Fields({ world }: { world: OwnWorld }) {
  const all = useWorld((state) => state.chosen);
  const report = useStudio((studio) => studio.report);
  const chosen = chosenIn(world, all);
  const [thing] = chosen;
  if (thing === undefined) return <WorldItself world={world} />;
  const part = partOf(world, thing);
  const problems = (report?.problems ?? []).filter((one) => {
    const found = thingNamed(world, one.thing);
    return found !== null && isSamePart(found, thing);
  });
  const several = chosen.length > 1;
  return (
    <section className="world-chosen column gap-m" aria-labelledby="world-chosen" data-testid="world-chosen">
      <header className="world-chosen-head row gap-xs">
        <h2 id="world-chosen">{several ? t("world.things", { count: chosen.length }) : kindName(thing.kind)}</h2>
        <Tool small icon="copy" label={t("world.duplicate")} testId="world-duplicate" onClick={duplicateChosen} />
        <Tool small icon="trash-2" label={t("world.delete")} testId="world-delete" onClick={removeChosen} />
      </header>
      {several ? (
        <p className="muted small-text">{t("world.several")}</p>
      ) : (
        <>
          {problems.map((problem, index) => (
            <p key={index} className="world-problem small-text" role="alert">
              <Icon name="circle-x" size={16} /> {sentence(problem.message)}{" "}
              {problem.help === "" ? null : <small className="block">{sentence(problem.help)}</small>}
            </p>
          ))}
          {isNamed(thing.kind) && part !== undefined && "name" in part ? (
            <NameCell
              key={`${thing.kind}${String(thing.at)}`}
              name={part.name}
              label={t("world.name")}
              testId="world-thing-name"
              wrong={(name) =>
                isNamed(thing.kind) && isFreeName(world, thing.kind, name)
                  ? ""
                  : t(name === "" ? "world.name-empty" : "world.name-taken", { name })
              }
              keep={(name) => execute(renameThing(useStudio.getState().mission, thing, name))}
            />
          ) : null}
          <PartFields key={`${thing.kind}:${String(thing.at)}`} world={world} thing={thing} />
        </>
      )}
    </section>
  );
}
