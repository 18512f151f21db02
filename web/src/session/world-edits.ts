/** What people do to the world with keys, buttons and menus; each is one command of the document. */
import { partsApi } from "../api/parts";
import { whyRefused } from "../api/refusal";
import { t } from "../i18n/words";
import type { Command } from "../model/command";
import { bringWorld, changeOwnWorld, isFreeName, isNamed, removeThings } from "../model/commands/changeOwnWorld";
import { changeWorld } from "../model/commands/changeWorld";
import { firstFree } from "../model/free-name";
import { startOf } from "../model/starts";
import { execute, useStudio } from "../model/studio";
import { typedName } from "../model/typed-name";
import type { Mission, OwnWorld } from "../model/types";
import { withStartsFor } from "../model/world/missing-starts";
import { startNear } from "../model/world/free-start";
import { drawNew, type Spot } from "../model/world/part-creation";
import { moved, startMoved } from "../model/world/part-movement";
import { nameOf } from "../model/world/names";
import { type Kind, partOf, type PartReference } from "../model/world/part-reference";
import { added, withDependents } from "../model/world/part-edits";
import { bannerAction, note, reportError } from "./document";
import { choose, chosenIn, ownWorld, say, startWith, useWorld } from "./world-view";

/** The mission's world becomes `world`, as one step. */
export function change(label: string, world: OwnWorld, joins?: string): boolean {
  return execute(changeOwnWorld(useStudio.getState().mission, label, world, joins));
}

/** What the mission's world is made of: its own, or that of its file; null with a word about why. */
export async function worldAsPlan(): Promise<OwnWorld | null> {
  const { mission, file } = useStudio.getState();
  if (mission.own_world != null) return mission.own_world;
  try {
    const { world, problems } = await partsApi.plan(file.path, mission.world);
    if (world !== null) return world;
    reportError(new Error(problems[0]?.message ?? t("world.no-file", { name: mission.world })));
  } catch (cause) {
    reportError(cause);
  }
  return null;
}

/** Copies the world of the file into the mission, so that it can be changed. */
export async function editWorld(): Promise<void> {
  const world = await worldAsPlan();
  const { mission } = useStudio.getState();
  if (world === null || mission.own_world != null) return;
  execute(bringWorld(mission, world));
  say(t("world.brought", { name: world.name }));
}

/** A world to begin with takes the place of the mission's, whatever that was; all robots have a start there. */
export function beginWith(world: OwnWorld, name: string): void {
  const { mission } = useStudio.getState();
  const label = t("world.template-taken", { name });
  execute({ ...bringWorld(mission, withStartsFor(world, mission.agents.map(startOf))), label });
  startWith([]);
  say(label);
}

/** The names of several things, as a label of undo. */
export function called(world: OwnWorld, things: readonly PartReference[]): string {
  const [first] = things;
  return things.length === 1 && first !== undefined
    ? nameOf(world, first)
    : t("world.things", { count: things.length });
}

export function removeChosen(): void {
  const { mission } = useStudio.getState();
  const world = ownWorld();
  const things = chosenIn(world, useWorld.getState().chosen);
  if (world === null || things.length === 0) return;
  const label = t("command.delete", { name: called(world, things) });
  const more = withDependents(world, things).length - things.length;
  if (!execute(removeThings(mission, label, things))) return;
  choose([]);
  say(more > 0 ? `${label}. ${t("world.deleted-more", { count: more })}` : label);
}

const STEP_MM = 40;

export function duplicateChosen(): void {
  const world = ownWorld();
  const things = chosenIn(world, useWorld.getState().chosen);
  if (world === null || things.length === 0) return;
  let after = world;
  const made: PartReference[] = [];
  for (const thing of things) {
    let part = partOf(after, thing);
    if (part === undefined) continue;
    if (isNamed(thing.kind) && "name" in part) part = { ...part, name: copyName(after, thing.kind, part.name) };
    const copied = added(after, thing.kind, part);
    made.push(copied.thing);
    after = moved(copied.world, copied.thing, STEP_MM, -STEP_MM);
  }
  const label = t("command.copy", { name: called(world, things) });
  if (!change(label, after)) return;
  choose(made);
  say(label);
}

function copyName(world: OwnWorld, kind: "road" | "storehouse" | "dock" | "start", name: string): string {
  const stem = name.replace(/-\d+$/, "");
  return firstFree(
    (number) => `${stem}-${String(number)}`,
    (next) => !isFreeName(world, kind, next),
    2,
  );
}

/** Moves what is chosen by so many mm; presses that follow each other closely are one step. */
export function nudge(dx: number, dy: number): void {
  const world = ownWorld();
  const things = chosenIn(world, useWorld.getState().chosen);
  if (world === null || things.length === 0) return;
  const after = things.reduce((one, thing) => moved(one, thing, dx, dy), world);
  const which = things.map(({ kind, at }) => `${kind}${String(at)}`).join(" ");
  change(t("command.move", { name: called(world, things) }), after, `world-move ${which}`);
}

/** Puts a new thing into the world and chooses it; false where it cannot be. */
export function put(kind: Kind, from: Spot, to: Spot | null): boolean {
  const world = ownWorld();
  const made = world === null ? null : drawNew(world, kind, from, to);
  if (made === null) {
    say(t("world.no-dock"));
    note(t("world.no-dock"));
    return false;
  }
  const label = t("command.add", { name: nameOf(made.world, made.thing) });
  change(label, made.world);
  startWith([made.thing]);
  say(label);
  return true;
}

/** Writes the mission's world to a file beside it; "" for done, else why not. */
export async function saveWorldFile(name: string): Promise<string> {
  const world = ownWorld();
  if (world === null) return "";
  const { path } = useStudio.getState().file;
  const stem = typedName(name).replace(/(\.world)?\.xml$/i, "");
  if (stem === "") return t("world.file-empty");
  try {
    const text = await partsApi.worldText({ ...world, name: stem });
    const bytes = new TextEncoder().encode(text).buffer;
    const { file } = await partsApi.add(path, `${stem}.world.xml`, bytes);
    const use = () => execute(changeWorld(useStudio.getState().mission, file));
    note(t("world.file-saved", { file }), "", [bannerAction(t("world.file-use"), use)]);
    return "";
  } catch (cause) {
    return whyRefused(cause).message;
  }
}

/** A robot dropped somewhere before a run starts there; the world is copied into the mission first where it must be. */
export async function moveStart(name: string, x: number, y: number): Promise<void> {
  const plan = await worldAsPlan();
  const at = plan?.starts.findIndex((start) => start.name === name) ?? -1;
  if (plan === null || at < 0) return;
  const world = startMoved(plan, at, x, y);
  if (world === plan) return;
  keepMoved(plan, world, t("command.move", { name }));
}

/**
 * One more robot at a start of the kind of the start `beside`, as one step: one that is free, else one that is made near that.
 * `add` gives the command of the robot, which may be called like a free start. False where the world cannot be read or has no
 * room.
 */
export async function addStarting(
  beside: string,
  add: (mission: Mission, start: string, isFree: boolean) => Command | null,
): Promise<boolean> {
  const plan = await worldAsPlan();
  if (plan === null) return false;
  const { mission } = useStudio.getState();
  const taken = new Set(mission.agents.map(startOf));
  const near = plan.starts.find((start) => start.name === beside);
  const free = plan.starts.find(({ name, at }) => !taken.has(name) && (near === undefined || at === near.at));
  if (free !== undefined) return execute(add(mission, free.name, true));
  const start = startNear(plan, beside, copyName(plan, "start", beside === "" ? "robot" : beside));
  if (start === null) return false;
  const world = { ...plan, starts: [...plan.starts, start] };
  const command = add({ ...mission, world: "", own_world: world }, start.name, false);
  if (command === null) return false;
  if (mission.own_world == null) bring(plan, command);
  else execute(command);
  return true;
}

/** Keeps `plan` as `world`, in which something was moved; a world of a file is copied into the mission, which is said. */
export function keepMoved(plan: OwnWorld, world: OwnWorld, label: string, joins?: string): void {
  const { mission } = useStudio.getState();
  if (mission.own_world != null) change(label, world, joins);
  else bring(plan, { ...bringWorld(mission, world), label });
}

/** Does what copies the world of a file into the mission, and says so. */
function bring(plan: OwnWorld, command: Command): void {
  execute(command);
  const undo = bannerAction(t("world.undo"), () => useStudio.getState().undo());
  note(t("world.brought", { name: plan.name }), "", [undo]);
}
