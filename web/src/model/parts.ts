/**
 * The parts a program can be made of, as the editor sees them: one `Shape` for every element of a robot's catalogue.
 *
 * A shape says which bodies, plugs and fields an element has and how it is coloured; that is all the editor ever asks, so
 * a constructor that nobody has thought of yet is drawn, edited and read like the shipped ones. An element whose XML is
 * missing has the shape `unknown`: its ports are read off its arcs (structure.ts).
 */
import { type Measure, measureOf } from "./meaning";
import { TEAM_ROBOT } from "./team-robot";
import { text } from "./texts";
import type { Catalogue, Colour, Constructor, Group, Method, Robot, RobotObject, Slot, Texts } from "./types";

/** What may stand where: in a chain, in a condition slot, in a value slot, on another constructor as one more branch. */
export type Role = "instruction" | "condition" | "value" | "branch" | "start" | "stop";

/** A slot that holds chains. `port` is the out-port; a repeated one counts: `branch.1`, `branch.2`, … */
export interface Flow {
  name: string;
  label: Texts;
  loop: boolean;
  repeat: boolean;
  least: number;
}

/** A slot that holds one vertex. */
export interface Plug {
  name: string;
  label: Texts;
  accepts: "condition" | "value" | "action";
}

/** Something typed in: a number in a range, a switch or a text. A field of the same name as a plug is typed or plugged. */
export interface Field extends Measure {
  name: string;
  label: Texts;
  help: Texts;
  kind: "integer" | "boolean" | "text";
  min: number;
  max: number;
  default: string;
}

export interface Shape {
  element: string;
  kind: "start" | "stop" | "constructor" | "method" | "unknown";
  role: Role;
  colour: Colour;
  icon: string;
  label: Texts;
  help: Texts;
  flows: Flow[];
  plugs: Plug[];
  fields: Field[];
  constructor_: Constructor | null;
  object: RobotObject | null;
  method: Method | null;
}

/** The parts of one robot. */
export interface Parts {
  robot: Robot | null;
  groups: Group[];
  shape: (element: string) => Shape;
  /** Shapes of every part on offer, in the order of the palette. */
  all: Shape[];
  /** Constructors whose only slot is an action: they mark the action they hold, and are drawn as a badge on it. */
  marks: Shape[];
}

const INTEGER_LIMIT = 65535;

function bare(element: string, kind: Shape["kind"], role: Role, icon: string): Shape {
  return {
    element,
    kind,
    role,
    colour: "action",
    icon,
    label: {},
    help: {},
    flows: [],
    plugs: [],
    fields: [],
    constructor_: null,
    object: null,
    method: null,
  };
}

function slotField(slot: Slot, robot: Robot | null): Field {
  return {
    name: slot.name,
    label: slot.label,
    help: {},
    kind: slot.kind === "text" ? "text" : "integer",
    min: slot.min ?? 0,
    max: slot.max ?? INTEGER_LIMIT,
    default: slot.default !== "" || slot.kind === "text" ? slot.default : String(slot.min ?? 0),
    ...measureOf(slot, robot),
  };
}

function constructorShape(one: Constructor, robot: Robot | null): Shape {
  const plugKind = { condition: "condition", value: "value", action: "action" } as const;
  return {
    element: one.name,
    kind: "constructor",
    role: one.role,
    colour: one.colour,
    icon: one.icon,
    label: one.label,
    help: one.help,
    flows: one.slots
      .filter((slot) => slot.kind === "flow")
      .map(({ name, label, loop, repeat, least }) => ({ name, label, loop, repeat, least })),
    plugs: one.slots.flatMap((slot) =>
      slot.kind === "condition" || slot.kind === "value" || slot.kind === "action"
        ? [{ name: slot.name, label: slot.label, accepts: plugKind[slot.kind] }]
        : [],
    ),
    fields: one.slots
      .filter((slot) => ["number", "text", "value"].includes(slot.kind))
      .map((slot) => slotField(slot, robot)),
    constructor_: one,
    object: null,
    method: null,
  };
}

function methodShape(object: RobotObject, method: Method, robot: Robot | null): Shape {
  const roles = { procedure: "instruction", test: "condition", value: "value" } as const;
  return {
    element: `${object.name}.${method.name}`,
    kind: "method",
    role: roles[method.kind],
    colour: method.kind === "procedure" ? "action" : "test",
    icon: method.kind === "procedure" ? method.icon || object.icon : object.icon || method.icon,
    label: method.label,
    help: method.help,
    flows: [],
    plugs: method.parameters.map(({ name, label, kind }) => ({
      name,
      label,
      accepts: kind === "boolean" ? "condition" : "value",
    })),
    fields: method.parameters.map((parameter) => ({
      ...parameter,
      ...measureOf(parameter, robot),
      default: String(parameter.default),
    })),
    constructor_: null,
    object,
    method,
  };
}

/** Whether a constructor can stand in programs of a robot: those of a team are made of more. */
export function standsFor({ level = "agent" }: Constructor, robot: Robot | null | undefined): boolean {
  return level === "agent" || robot?.name === TEAM_ROBOT;
}

function makeParts(catalogue: Catalogue, robot: Robot | null): Parts {
  const table = new Map<string, Shape>();
  const all: Shape[] = [];
  const add = (shape: Shape) => {
    if (table.has(shape.element)) return;
    table.set(shape.element, shape);
    all.push(shape);
  };
  for (const group of catalogue.groups)
    for (const one of group.constructors) if (standsFor(one, robot)) add(constructorShape(one, robot));
  for (const object of robot?.objects ?? [])
    for (const method of object.methods) add(methodShape(object, method, robot));
  table.set("Start", bare("Start", "start", "start", "play"));
  table.set("Stop", bare("Stop", "stop", "stop", "square"));
  return {
    robot,
    groups: catalogue.groups,
    all,
    marks: all.filter(isMark),
    shape: (element) => {
      let found = table.get(element);
      if (found === undefined) {
        found = bare(element, "unknown", "instruction", "circle-help");
        table.set(element, found);
      }
      return found;
    },
  };
}

const made = new WeakMap<Catalogue, Map<string, Parts>>();

/** The parts of that robot (by name) in the catalogue; a robot we do not have offers the constructors only. */
export function partsOf(catalogue: Catalogue, robot: string): Parts {
  let byRobot = made.get(catalogue);
  if (byRobot === undefined) made.set(catalogue, (byRobot = new Map<string, Parts>()));
  let parts = byRobot.get(robot);
  if (parts === undefined) {
    parts = makeParts(catalogue, catalogue.robots.find((one) => one.name === robot) ?? null);
    byRobot.set(robot, parts);
  }
  return parts;
}

/** Whether the shape only marks an action: drawn as a badge on it. */
export function isMark(shape: Shape): boolean {
  return (
    shape.kind === "constructor" &&
    shape.role === "instruction" &&
    shape.constructor_?.slots.length === 1 &&
    shape.plugs[0]?.accepts === "action"
  );
}

/** Whether a vertex of that shape may fill the plug. */
export function fits(shape: Shape, plug: Plug): boolean {
  if (plug.accepts === "action") return shape.kind === "method" && shape.role === "instruction";
  return shape.role === plug.accepts;
}

/** Whether that shape may stand in a chain. */
export function standsInChain(shape: Shape): boolean {
  return shape.role === "instruction";
}

/** The instruction that only waits for a condition: a test that is dropped into a chain comes in one. */
export function waitingFor(parts: Parts, test: Shape): Shape | undefined {
  if (test.role !== "condition") return undefined;
  return parts.all.find(
    ({ role, flows, fields, plugs }) =>
      role === "instruction" &&
      flows.length + fields.length === 0 &&
      plugs.map((plug) => plug.accepts).join() === "condition",
  );
}

/** The name as the reader knows it: "Repeat while", "Wheels Drive". */
export function title(shape: Shape): string {
  const object = objectTitle(shape);
  return object === "" ? shortTitle(shape) : `${object} ${shortTitle(shape)}`;
}

/** The name of its object; "" where its own name says all. */
export function objectTitle({ object, method }: Shape): string {
  return object === null || method?.alone === true ? "" : text(object.label, object.name);
}

/** The name without its object: "Drive". */
export function shortTitle(shape: Shape): string {
  return text(shape.label, shape.method?.name ?? shape.element);
}

/** The field of that name, or undefined for a slot that is only plugged. */
export function fieldOf(shape: Shape, name: string): Field | undefined {
  return shape.fields.find((field) => field.name === name);
}
