/**
 * The palette as rows: constructors by group, then the robot's actuators, sensors and variables with their methods.
 *
 * Pure: the catalogue, what is folded and what is searched go in, rows come out in the order of the screen.
 */
import { type Key, t } from "../../i18n/words";
import { type Parts, type Shape, shortTitle, title } from "../../model/parts";
import { TEAM_ROBOT } from "../../model/team-robot";
import { text } from "../../model/texts";
import type { RobotObject } from "../../model/types";

export type Row =
  | { kind: "heading"; key: string; label: string }
  | {
      kind: "fold";
      key: string;
      level: number;
      label: string;
      open: boolean;
      aside: string;
      object: RobotObject | null;
    }
  | { kind: "part"; key: string; level: number; label: string; shape: Shape; aside: string }
  | { kind: "new"; key: string; level: number; label: string };

/** Folded rows by key; what is not in it is as it is at first. */
export type Folded = Readonly<Record<string, boolean>>;

const SECTIONS: readonly { category: RobotObject["category"]; label: Key }[] = [
  { category: "actuator", label: "parts.actuators" },
  { category: "sensor", label: "parts.sensors" },
  { category: "variable", label: "parts.variables" },
  { category: "system", label: "parts.system" },
];

/** Whether a part's names hold every word that was typed. */
export function matches(shape: Shape, query: string): boolean {
  const names = `${title(shape)} ${shape.element} ${shape.constructor_?.group ?? ""}`.toLowerCase();
  return query
    .toLowerCase()
    .split(/\s+/)
    .every((word) => names.includes(word));
}

export function rowsOf(parts: Parts, query: string, folded: Folded): Row[] {
  const wanted = query.trim();
  const shown = parts.all.filter((shape) => wanted === "" || matches(shape, wanted));
  const constructors = constructorRows(parts, shown, wanted !== "", folded);
  const objects = robotRows(parts, shown, wanted !== "", folded);
  const heading = (key: string, label: Key): Row => ({ kind: "heading", key, label: t(label) });
  const ofTeam = parts.robot?.name === TEAM_ROBOT;
  return [
    ...(constructors.length > 0 ? [heading("constructors", "parts.constructors"), ...constructors] : []),
    ...(objects.length > 0 ? [heading("robot", ofTeam ? "team.tab" : "parts.robot"), ...objects] : []),
  ];
}

/** What has to be unfolded so that a part can be seen. */
export function unfoldedFor(parts: Parts, element: string): Folded {
  const shape = parts.all.find((one) => one.element === element);
  if (shape === undefined) return {};
  if (shape.object === null) return { [`group ${shape.constructor_?.group ?? ""}`]: false };
  const { category, name } = shape.object;
  return { [`section ${category}`]: false, [`object ${category} ${name}`]: false };
}

function constructorRows(parts: Parts, shown: Shape[], searching: boolean, folded: Folded): Row[] {
  return parts.groups.flatMap((group): Row[] => {
    const members = shown.filter((shape) => group.constructors.some((one) => one === shape.constructor_));
    if (members.length === 0) return [];
    const key = `group ${group.name}`;
    // Conditions stand in chips, not in the flow: they are looked for less often.
    const open = searching || !(folded[key] ?? members.every((shape) => shape.role === "condition"));
    const aside = open ? "" : members.map(shortTitle).join(" · ");
    const head: Row = { kind: "fold", key, level: 1, label: text(group.label, group.name), open, aside, object: null };
    return open ? [head, ...members.map((shape) => partRow(shape, 2))] : [head];
  });
}

function robotRows(parts: Parts, shown: Shape[], searching: boolean, folded: Folded): Row[] {
  const objects = parts.robot?.objects ?? [];
  let first = true;
  return SECTIONS.flatMap(({ category, label }): Row[] => {
    const here = objects.filter((object) => object.category === category);
    const inside = here.flatMap((object): Row[] => {
      const methods = shown.filter((shape) => shape.object === object);
      if (methods.length === 0) return [];
      const key = `object ${category} ${object.name}`;
      const open = searching || !(folded[key] ?? !first);
      first = false;
      const head: Row = {
        kind: "fold",
        key,
        level: 2,
        label: text(object.label, object.name),
        open,
        aside: "",
        object,
      };
      return open ? [head, ...methods.map((shape) => partRow(shape, 3))] : [head];
    });
    // New ones are made where the others are, and where there is none yet.
    const fresh: Row[] =
      category === "variable" && !searching && parts.robot !== null && parts.robot.name !== TEAM_ROBOT
        ? [{ kind: "new", key: "new variable", level: 2, label: t("variable.new") }]
        : [];
    if (inside.length + fresh.length === 0) return [];
    const key = `section ${category}`;
    const open = searching || folded[key] !== true;
    const head: Row = { kind: "fold", key, level: 1, label: t(label), open, aside: "", object: null };
    return open ? [head, ...inside, ...fresh] : [head];
  });
}

function partRow(shape: Shape, level: number): Row {
  const aside = shape.fields.map((field) => text(field.label, field.name)).join(", ");
  return {
    kind: "part",
    key: `part ${shape.element}`,
    level,
    label: shortTitle(shape),
    shape,
    aside: level === 3 ? aside : "",
  };
}
