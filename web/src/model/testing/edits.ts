/** Edits at random, of a program and of everything else that a mission holds; the same for the same numbers. */
import type { Command } from "../command";
import {
  addAgent,
  copyAgent,
  giveProgram,
  giveStart,
  moveAgent,
  placeAgents,
  removeAgent,
  renameAgent,
} from "../commands/changeAgents";
import { addBranch, removeBranch } from "../commands/changeBranches";
import { addGoal, changeGoal, removeGoal } from "../commands/changeGoals";
import {
  addConstructor,
  addVariable,
  changeConstructor,
  changeVariable,
  removeConstructor,
  removeVariable,
} from "../commands/changeOwn";
import { addProgram, emptyProgram, moveProgram, removeProgram, renameProgram } from "../commands/changePrograms";
import { changeTitle } from "../commands/changeTitle";
import { changeWorld } from "../commands/changeWorld";
import { deleteParts } from "../commands/deleteParts";
import { insertPart } from "../commands/insertPart";
import { copyParts, moveParts } from "../commands/moveParts";
import { pasteParts } from "../commands/pasteParts";
import { setField } from "../commands/setField";
import { setNote } from "../commands/setNote";
import { toggleMark } from "../commands/toggleMark";
import { unwrapPart, wrapParts } from "../commands/wrapParts";
import { copyOf } from "../fragment";
import { ownConstructors, ownVariables } from "../own-parts";
import { readStructure } from "../structure";
import type { Mission, OwnVariable, Program } from "../types";
import { CARRIER_PARTS as PARTS, pick, placesOf } from "./missions";
import { PARTS as CATALOGUE } from "./parts";

type Random = () => number;

/** A random edit of a program, or null when the dice found none. */
export function randomEdit(random: Random, program: Program): Command | null {
  const ids = program.vertices.map((one) => one.id);
  const id = pick(random, ids);
  const place = pick(random, placesOf(program));
  const dice = random();
  if (dice < 0.43) return insertPart(program, PARTS, place, pick(random, PARTS.all).element);
  if (dice < 0.49) return wrapParts(program, PARTS, [id, pick(random, ids)], pick(random, PARTS.all).element);
  if (dice < 0.52) return unwrapPart(program, PARTS, id);
  if (dice < 0.55) {
    const piece = copyOf(readStructure(program, PARTS), [id])?.program;
    return piece === undefined ? null : pasteParts(program, PARTS, place, piece);
  }
  if (dice < 0.65) return moveParts(program, PARTS, [id, pick(random, ids)], place);
  if (dice < 0.7) return copyParts(program, PARTS, [id], place);
  if (dice < 0.8) return deleteParts(program, PARTS, [id]);
  if (dice < 0.85) return toggleMark(program, PARTS, id, "Interrupt");
  if (dice < 0.9) return addBranch(program, PARTS, id);
  if (dice < 0.93) return removeBranch(program, PARTS, id, "branch.1");
  if (dice < 0.96) return setNote(program, id, `note ${String(random())}`);
  return setField(program, PARTS, id, "speed", String(Math.floor(random() * 100)));
}

const NAMES = ["scout", "carrier-1", "Trips", "چکر", "b", "c-2", ""] as const;
const STARTS = ["carrier-1", "dock", "x"] as const;

function variableLike(random: Random, robot: string): OwnVariable {
  const found = CATALOGUE.robots.flatMap((one) => one.objects).filter((one) => one.category === "variable");
  return { robot, variable: { ...pick(random, found), name: pick(random, NAMES), shared: random() < 0.5 } };
}

function randomTeam(random: Random, mission: Mission): Command | null {
  const at = Math.floor(random() * (mission.agents.length + 1));
  const program = pick(random, mission.programs).name;
  const name = pick(random, NAMES);
  const kinds: (() => Command | null)[] = [
    () => addAgent(mission, name, program, pick(random, STARTS)),
    () => giveProgram(mission, at, program),
    () => giveStart(mission, at, pick(random, STARTS)),
    () => renameAgent(mission, at, name),
    () => copyAgent(mission, at, name, pick(random, STARTS)),
    () => moveAgent(mission, at, Math.floor(random() * 4)),
    () => removeAgent(mission, at),
    () => placeAgents(mission, STARTS),
    () => addGoal(mission, pick(random, ["A", "B"])),
    () => changeGoal(mission, at, { storehouse: "B", stock: pick(random, ["all", "3", "12"]) }),
    () => removeGoal(mission, at),
    () => changeWorld(mission, pick(random, ["", "ring.world.xml", "empty.world.xml", "yard.world.xml"])),
    () => changeTitle(mission, pick(random, ["label", "help"]), pick(random, ["", "fr", "ur"]), name),
  ];
  return pick(random, kinds)();
}

function randomParts(random: Random, mission: Mission): Command | null {
  const robot = pick(random, ["carrier", "loader"]);
  const variables = ownVariables(mission);
  const variable = variables.length === 0 ? undefined : pick(random, variables);
  const constructors = ownConstructors(mission);
  const made = pick(
    random,
    CATALOGUE.groups.flatMap((group) => group.constructors),
  );
  const own = { ...made, name: pick(random, ["Mine", "Yours", "میرا"]) };
  const of = constructors.length === 0 ? "" : pick(random, constructors).name;
  const kinds: (() => Command | null)[] = [
    () => addVariable(mission, variableLike(random, robot)),
    () =>
      variable === undefined
        ? null
        : changeVariable(mission, variable.robot, variable.variable.name, variableLike(random, variable.robot)),
    () => (variable === undefined ? null : removeVariable(mission, variable.robot, variable.variable.name)),
    () => addConstructor(mission, own),
    () => changeConstructor(mission, of, own),
    () => removeConstructor(mission, of),
  ];
  return pick(random, kinds)();
}

function randomPrograms(random: Random, mission: Mission): Command | null {
  const program = pick(random, mission.programs).name;
  const kinds: (() => Command | null)[] = [
    () => addProgram(mission, emptyProgram(pick(random, NAMES), pick(random, ["carrier", "loader", "rover"]))),
    () => renameProgram(mission, program, pick(random, NAMES)),
    () => removeProgram(mission, program),
    () => moveProgram(mission, program, pick(random, [1, -1])),
  ];
  return pick(random, kinds)();
}

/** A random edit of anything in a mission, or null when the dice found none. */
export function randomChange(random: Random, mission: Mission): Command | null {
  const dice = random();
  if (dice < 0.45) {
    // The parts are the carrier's.
    const ours = mission.programs.filter((one) => one.robot === "carrier");
    return ours.length === 0 ? null : randomEdit(random, pick(random, ours));
  }
  if (dice < 0.7) return randomTeam(random, mission);
  if (dice < 0.9) return randomParts(random, mission);
  return randomPrograms(random, mission);
}
