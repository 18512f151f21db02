/** The numbers and names of what is chosen; of the world itself when nothing is. */
import { changeOwnWorld, isFreeName, isNamed, renameThing } from "../model/commands/changeOwnWorld";
import { useStudio } from "../model/studio";
import type { Corner, OwnWorld } from "../model/types";
import { lineOf, startPlace } from "../model/world/drawn";
import { nearestOn } from "../model/world/line";
import { LARGEST_MM, type Part, partOf, sameThing, type Thing, thingNamed, tidy } from "../model/world/thing";
import { withClosed, withPart, withPoints, withSections } from "../model/world/things";
import { NameCell } from "../team/NameCell";
import { Icon } from "../theme";
import { type Key, sentence, t } from "../words/words";
import { change, duplicateChosen, execute, removeChosen } from "./act";
import { kindName, nameOf } from "./names";
import { NumberField } from "./NumberField";
import { chosenIn, useWorld } from "./state";

const MOST = 65535;

interface PartProps<P> {
  world: OwnWorld;
  thing: Thing;
  part: P;
}

function set(world: OwnWorld, thing: Thing, after: OwnWorld, what = "", stepped = false): void {
  const label = t("command.edit", { name: nameOf(world, thing) });
  change(label, after, stepped ? `world ${thing.kind} ${String(thing.at)} ${what}` : undefined);
}

/** Fields that are numbers in mm, by their names in the part. */
function Numbers<P extends Part<Thing["kind"]>>({
  world,
  thing,
  part,
  names,
  least = 0,
}: PartProps<P> & { names: readonly (keyof P & string)[]; least?: number }) {
  return (
    <div className="world-fields">
      {names.map((name) => (
        <NumberField
          key={name}
          label={t(`world.${name}` as Key)}
          value={part[name] as number}
          min={least}
          max={LARGEST_MM}
          testId={`world-${name}`}
          keep={(value, stepped) =>
            set(world, thing, withPart(world, thing, { ...part, [name]: tidy(value) }), name, stepped)
          }
        />
      ))}
    </div>
  );
}

interface ChoiceProps {
  label: string;
  value: string;
  options: readonly [value: string, words: string][];
  testId: string;
  keep: (value: string) => void;
}

function Choice({ label, value, options, testId, keep }: ChoiceProps) {
  const known = options.some(([one]) => one === value);
  return (
    <label className="world-field">
      <span>{label}</span>
      <select
        className="field"
        data-testid={testId}
        value={value}
        aria-invalid={!known}
        onChange={(event) => keep(event.target.value)}
      >
        {known ? null : <option value={value}>{value}</option>}
        {options.map(([one, words]) => (
          <option key={one} value={one}>
            {words}
          </option>
        ))}
      </select>
    </label>
  );
}

function Colour({ world, thing, part }: PartProps<Part<"line"> | Part<"floor">>) {
  return (
    <Choice
      label={t("world.colour")}
      testId="world-colour"
      value={part.colour}
      options={(["red", "green", "blue"] as const).map((one) => [one, t(`world.${one}` as Key)])}
      keep={(colour) => set(world, thing, withPart(world, thing, { ...part, colour } as typeof part))}
    />
  );
}

function Count({
  label,
  value,
  name,
  keep,
}: {
  label: string;
  value: number;
  name: string;
  keep: (n: number) => void;
}) {
  return (
    <NumberField
      label={label}
      value={value}
      unit=""
      min={0}
      max={MOST}
      step={1}
      testId={`world-${name}`}
      keep={(one) => keep(Math.round(one))}
    />
  );
}

/** The corners of a floor, a line or a road: each with its place and radius; put in and taken out. */
function Corners({ world, thing, part }: PartProps<Part<"line"> | Part<"floor"> | Part<"road">>) {
  const closed = thing.kind === "floor" || ("closed" in part && part.closed);
  const least = closed ? 3 : 2;
  const { points } = part;
  const keep = (after: Corner[], what = "", stepped = false) =>
    set(world, thing, withPoints(world, thing, after), what, stepped);
  const insert = (at: number) => {
    const [a, b] = [points[at], points[(at + 1) % points.length]];
    if (a === undefined || b === undefined) return;
    const between =
      at === points.length - 1 && !closed
        ? { x: tidy(a.x + 100), y: a.y, radius: 0 }
        : { x: tidy((a.x + b.x) / 2), y: tidy((a.y + b.y) / 2), radius: 0 };
    keep([...points.slice(0, at + 1), between, ...points.slice(at + 1)]);
  };
  return (
    <fieldset className="world-corners">
      <legend>{t("world.corners")}</legend>
      {points.map((point, at) => (
        <div className="world-corner" key={at}>
          <span className="world-corner-number">{at + 1}</span>
          {(["x", "y", "radius"] as const).map((name) => (
            <NumberField
              key={name}
              label={t(`world.${name}` as Key)}
              unit=""
              value={point[name]}
              min={name === "radius" ? 0 : -LARGEST_MM}
              max={LARGEST_MM}
              testId={`world-corner-${String(at)}-${name}`}
              keep={(value, stepped) =>
                keep(
                  points.map((one, index) => (index === at ? { ...one, [name]: tidy(value) } : one)),
                  `${name}${String(at)}`,
                  stepped,
                )
              }
            />
          ))}
          <button
            type="button"
            className="tool small"
            data-testid={`world-corner-${String(at)}-add`}
            aria-label={t("world.corner-add", { number: at + 1 })}
            title={t("world.corner-add", { number: at + 1 })}
            onClick={() => insert(at)}
          >
            <Icon name="plus" size={14} />
          </button>
          <button
            type="button"
            className="tool small"
            data-testid={`world-corner-${String(at)}-remove`}
            aria-label={t("world.corner-remove", { number: at + 1 })}
            title={t("world.corner-remove", { number: at + 1 })}
            disabled={points.length <= least}
            onClick={() => keep(points.filter((_, index) => index !== at))}
          >
            <Icon name="x" size={14} />
          </button>
        </div>
      ))}
    </fieldset>
  );
}

function Closed({ world, thing, part }: PartProps<Part<"line"> | Part<"road">>) {
  return (
    <label className="world-check">
      <input
        type="checkbox"
        data-testid="world-closed"
        checked={part.closed}
        disabled={!part.closed && part.points.length < 3}
        onChange={(event) => {
          const closed = event.target.checked;
          const after =
            thing.kind === "road" ? withClosed(world, thing.at, closed) : withPart(world, thing, { ...part, closed });
          set(world, thing, after);
        }}
      />
      {t("world.closed")}
    </label>
  );
}

function names(list: readonly { name: string }[]): [string, string][] {
  return list.map(({ name }) => [name, name]);
}

function DockFields({ world, thing, part }: PartProps<Part<"dock">>) {
  const keep = (more: Partial<Part<"dock">>) => set(world, thing, withPart(world, thing, { ...part, ...more }));
  return (
    <>
      <Numbers world={world} thing={thing} part={part} names={["at_mm", "reach_mm"]} />
      <div className="world-fields">
        <Choice
          label={t("world.kind-road")}
          testId="world-road"
          value={part.road}
          options={names(world.roads)}
          keep={(road) => keep({ road })}
        />
        <Choice
          label={t("world.kind-storehouse")}
          testId="world-storehouse"
          value={part.storehouse}
          options={names(world.storehouses)}
          keep={(storehouse) => keep({ storehouse })}
        />
        <Choice
          label={t("world.does")}
          testId="world-kind"
          value={part.kind}
          options={[
            ["load", t("world.load")],
            ["unload", t("world.unload")],
          ]}
          keep={(kind) => keep({ kind: kind === "load" ? "load" : "unload" })}
        />
        <Choice
          label={t("world.side")}
          testId="world-side"
          value={part.side}
          options={[
            ["left", t("world.left")],
            ["right", t("world.right")],
          ]}
          keep={(side) => keep({ side: side === "right" ? "right" : "left" })}
        />
      </div>
    </>
  );
}

/** The start somewhere else of another kind: at the nearest place of that kind. */
function startAt(world: OwnWorld, part: Part<"start">, at: Part<"start">["at"]): Part<"start"> {
  const place = startPlace(world, part) ?? { x: world.width_mm / 2, y: world.height_mm / 2, heading: 0 };
  const bare = { ...part, at, road: "", at_mm: 0, dock: "", storehouse: "", x_mm: 0, y_mm: 0, heading_deg: 0 };
  if (at === "dock") return { ...bare, dock: world.docks[0]?.name ?? "" };
  if (at === "storehouse") return { ...bare, storehouse: world.storehouses[0]?.name ?? "" };
  if (at === "pose") {
    const heading_deg = Math.round((place.heading * 180) / Math.PI);
    return { ...bare, x_mm: Math.round(place.x), y_mm: Math.round(place.y), heading_deg };
  }
  const road = world.roads[0];
  const line = road === undefined ? null : lineOf(road.points, road.closed);
  const along = line === null ? 0 : Math.round(nearestOn(line, place.x, place.y).at);
  return { ...bare, road: road?.name ?? "", at_mm: along };
}

function StartFields({ world, thing, part }: PartProps<Part<"start">>) {
  const keep = (more: Part<"start">, what = "", stepped = false) =>
    set(world, thing, withPart(world, thing, more), what, stepped);
  const places: [string, string, boolean][] = [
    ["pose", t("world.on-floor"), true],
    ["road", t("world.kind-road"), world.roads.length > 0],
    ["dock", t("world.kind-dock"), world.docks.length > 0],
    ["storehouse", t("world.kind-storehouse"), world.storehouses.length > 0],
  ];
  const options = places.flatMap(([value, words, there]): [string, string][] => (there ? [[value, words]] : []));
  return (
    <>
      <div className="world-fields">
        <Choice
          label={t("world.where")}
          testId="world-where"
          value={part.at}
          options={options}
          keep={(at) => keep(startAt(world, part, at as Part<"start">["at"]))}
        />
        {part.at === "pose" ? (
          <NumberField
            label={t("world.heading")}
            unit="°"
            value={part.heading_deg}
            min={-360}
            max={360}
            step={5}
            testId="world-heading"
            keep={(heading_deg, stepped) => keep({ ...part, heading_deg: tidy(heading_deg) }, "heading", stepped)}
          />
        ) : (
          <Choice
            label={t(`world.kind-${part.at}` as Key)}
            testId={`world-${part.at}`}
            value={part[part.at]}
            options={names(world[`${part.at}s`])}
            keep={(name) => keep({ ...part, [part.at]: name })}
          />
        )}
      </div>
      {part.at === "pose" ? (
        <Numbers world={world} thing={thing} part={part} names={["x_mm", "y_mm"]} least={-LARGEST_MM} />
      ) : null}
      {part.at === "road" ? <Numbers world={world} thing={thing} part={part} names={["at_mm"]} /> : null}
    </>
  );
}

function RoadFields({ world, thing, part }: PartProps<Part<"road">>) {
  return (
    <>
      <Numbers world={world} thing={thing} part={part} names={["width_mm"]} least={1} />
      <Closed world={world} thing={thing} part={part} />
      <Count
        label={t("world.sections")}
        value={part.sections.length}
        name="sections"
        keep={(count) => set(world, thing, withSections(world, thing.at, Math.min(count, 200)))}
      />
      <Corners world={world} thing={thing} part={part} />
    </>
  );
}

function HouseFields({ world, thing, part }: PartProps<Part<"storehouse">>) {
  const keep = (more: Partial<Part<"storehouse">>) => set(world, thing, withPart(world, thing, { ...part, ...more }));
  return (
    <>
      <Numbers world={world} thing={thing} part={part} names={["x_mm", "y_mm"]} least={-LARGEST_MM} />
      <Numbers world={world} thing={thing} part={part} names={["width_mm", "height_mm"]} least={1} />
      <div className="world-fields">
        <Count
          label={t("world.capacity")}
          value={part.capacity}
          name="capacity"
          keep={(capacity) => keep({ capacity })}
        />
        <Count label={t("world.stock")} value={part.stock} name="stock" keep={(stock) => keep({ stock })} />
      </div>
    </>
  );
}

function PartFields({ world, thing }: { world: OwnWorld; thing: Thing }) {
  const { kind, at } = thing;
  switch (kind) {
    case "wall": {
      const part = partOf(world, { kind, at });
      const names = ["x1", "y1", "x2", "y2"] as const;
      return part && <Numbers world={world} thing={thing} part={part} names={names} least={-LARGEST_MM} />;
    }
    case "floor": {
      const part = partOf(world, { kind, at });
      return (
        part && (
          <>
            <Colour world={world} thing={thing} part={part} />
            <Corners world={world} thing={thing} part={part} />
          </>
        )
      );
    }
    case "line": {
      const part = partOf(world, { kind, at });
      return (
        part && (
          <>
            <Colour world={world} thing={thing} part={part} />
            <Numbers world={world} thing={thing} part={part} names={["width_mm"]} least={0.1} />
            <Closed world={world} thing={thing} part={part} />
            <Corners world={world} thing={thing} part={part} />
          </>
        )
      );
    }
    case "road": {
      const part = partOf(world, { kind, at });
      return part && <RoadFields world={world} thing={thing} part={part} />;
    }
    case "storehouse": {
      const part = partOf(world, { kind, at });
      return part && <HouseFields world={world} thing={thing} part={part} />;
    }
    case "dock": {
      const part = partOf(world, { kind, at });
      return part && <DockFields world={world} thing={thing} part={part} />;
    }
    case "start": {
      const part = partOf(world, { kind, at });
      return part && <StartFields world={world} thing={thing} part={part} />;
    }
  }
}

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
    <section className="world-chosen" aria-labelledby="world-itself">
      <h2 id="world-itself">{t("world.tab")}</h2>
      <NameCell
        name={world.name}
        label={t("world.name")}
        testId="world-name"
        wrong={(name) => (name === "" ? t("world.name-empty") : "")}
        keep={(name) => keep({ name })}
      />
      <div className="world-fields">
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
      <p className="world-hint">{t("world.hint")}</p>
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
    return found !== null && sameThing(found, thing);
  });
  const several = chosen.length > 1;
  return (
    <section className="world-chosen" aria-labelledby="world-chosen" data-testid="world-chosen">
      <header className="world-chosen-head">
        <h2 id="world-chosen">{several ? t("world.things", { count: chosen.length }) : kindName(thing.kind)}</h2>
        <button
          type="button"
          className="tool small"
          data-testid="world-duplicate"
          aria-label={t("world.duplicate")}
          title={t("world.duplicate")}
          onClick={duplicateChosen}
        >
          <Icon name="copy" size={16} />
        </button>
        <button
          type="button"
          className="tool small"
          data-testid="world-delete"
          aria-label={t("world.delete")}
          title={t("world.delete")}
          onClick={removeChosen}
        >
          <Icon name="trash-2" size={16} />
        </button>
      </header>
      {several ? (
        <p className="world-hint">{t("world.several")}</p>
      ) : (
        <>
          {problems.map((problem, index) => (
            <p key={index} className="world-problem" role="alert">
              <Icon name="circle-x" size={16} /> {sentence(problem.message)}{" "}
              {problem.help === "" ? null : <small>{sentence(problem.help)}</small>}
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
