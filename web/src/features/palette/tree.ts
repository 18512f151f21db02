/**
 * The palette as tabs: constructors and the robot's parts by the group that their XML names, in the order of that XML.
 *
 * Pure: the catalogue and what is searched go in, tabs with rows come out in the order of the screen. What says its
 * place comes first in its tab; the other methods of a robot's object stand under its name.
 */
import { t } from "../../i18n/words";
import { inWords, storedNumber } from "../../model/meaning";
import { groupOf, LAST_PLACE, placeInGroup } from "../../model/part-groups";
import { type Parts, type Shape, shortTitle, title } from "../../model/parts";
import { rank } from "../../model/part-search";
import { TEAM_ROBOT } from "../../model/team-robot";
import { text } from "../../model/texts";
import { type BuiltKit, isAbsent } from "../../session/kit";
import type { Colour, Group, RobotObject } from "../../model/types";

export type Row =
  | { kind: "object"; key: string; label: string; object: RobotObject }
  | { kind: "part"; key: string; level: number; label: string; shape: Shape; aside: string }
  | { kind: "new"; key: string; label: string };

export interface Tab {
  name: string;
  label: string;
  icon: string;
  colour: Colour;
  rows: Row[];
}

/** What was typed may be found in a name, or only in a word. */
interface RankedShape {
  shape: Shape;
  rank: number;
}

/** Whether its name alone says what it does, or its place is its own: it needs no heading. */
function standsAlone(shape: Shape): boolean {
  const { object, method } = shape;
  if (object === null) return true;
  return object.category === "actuator" && (method?.alone === true || placeInGroup(shape) < LAST_PLACE);
}

/** The parts without those that a kit has nothing for. */
export function partsOfKit(parts: Parts, kit: BuiltKit | null, robot: string): Parts {
  if (kit === null) return parts;
  return { ...parts, all: parts.all.filter(({ object }) => object === null || !isAbsent(kit, robot, object)) };
}

export function tabsOf(parts: Parts, query: string): Tab[] {
  const searching = query.trim() !== "";
  const byGroup = new Map<Group | undefined, RankedShape[]>();
  for (const shape of parts.all) {
    const found = rank(shape, query);
    if (found === null) continue;
    const group = groupOf(parts, shape);
    byGroup.set(group, [...(byGroup.get(group) ?? []), { shape, rank: found }]);
  }
  const best = (group: Group | undefined) => Math.min(...(byGroup.get(group) ?? []).map(({ rank }) => rank));
  const groups: (Group | undefined)[] = [...parts.groups, undefined];
  if (searching) groups.sort((a, b) => (byGroup.has(a) && byGroup.has(b) ? best(a) - best(b) : 0));
  return groups.flatMap((group): Tab[] => {
    const found = byGroup.get(group) ?? [];
    const rows = searching ? foundRows(found) : allRows(found);
    if (!searching && group?.holds === "values") {
      // New ones are made where the others are.
      const after = rows.findIndex((row) => row.kind === "object" && row.object.category === "system");
      rows.splice(after < 0 ? rows.length : after, 0, ...newRow(parts));
    }
    if (rows.length === 0) return [];
    // What no file has a tab for stands at the end.
    const { name, label, icon = "", colour } = group ?? { name: "", label: {}, colour: "action" as const };
    return [{ name, label: text(label, name || t("parts.robot")), icon: icon || "boxes", colour, rows }];
  });
}

/** The key of the row that shows a part. */
export function rowOfPart(element: string): string {
  return `part ${element}`;
}

/** What answers a search, the best first, each by its whole name. */
function foundRows(found: RankedShape[]): Row[] {
  return [...found].sort((a, b) => a.rank - b.rank).map(({ shape }) => partRow(shape, title(shape), 1));
}

function allRows(found: RankedShape[]): Row[] {
  const shapes = found.map(({ shape }) => shape);
  const alone = shapes.filter(standsAlone).sort((a, b) => placeInGroup(a) - placeInGroup(b));
  const others = shapes.filter((shape) => !standsAlone(shape));
  const objects = [...new Set(others.flatMap(({ object }) => object ?? []))];
  return [
    ...alone.map((shape) => partRow(shape, shortTitle(shape), 1)),
    ...objects.flatMap((object): Row[] => [
      {
        kind: "object",
        key: `object ${object.category} ${object.name}`,
        label: text(object.label, object.name),
        object,
      },
      ...others.filter((shape) => shape.object === object).map((shape) => partRow(shape, shortTitle(shape), 2)),
    ]),
  ];
}

function newRow({ robot }: Parts): Row[] {
  if (robot === null || robot.name === TEAM_ROBOT) return [];
  return [{ kind: "new", key: "new variable", label: t("variable.new") }];
}

function partRow(shape: Shape, label: string, level: number): Row {
  const [field] = shape.fields;
  const aside =
    field?.kind === "integer" && field.default !== "" ? inWords(field, storedNumber(field.default) ?? field.min) : "";
  return { kind: "part", key: rowOfPart(shape.element), level, label, shape, aside };
}
