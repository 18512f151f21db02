/**
 * What the page knows of a mission and of the parts it is drawn from: the shapes that the server sends and takes.
 *
 * Plain data. Nothing is ever changed in place: an edit makes new objects for what it touches and keeps the rest, so
 * that `===` tells what changed.
 */

/** Language tag → text; the empty tag is the default (English). */
export type Texts = Record<string, string>;

export type Colour = "loop" | "choice" | "parallel" | "action" | "test" | "team";
export type SlotKind = "flow" | "condition" | "value" | "number" | "text" | "action";

export interface Slot {
  name: string;
  kind: SlotKind;
  label: Texts;
  loop: boolean;
  repeat: boolean;
  least: number;
  min: number | null;
  max: number | null;
  default: string;
  unit: string;
}

export interface Constructor {
  name: string;
  group: string;
  icon: string;
  colour: Colour;
  label: Texts;
  help: Texts;
  slots: Slot[];
  role: "instruction" | "condition" | "branch";
  adds: { constructor: string; slot: string } | null;
  code: string;
}

export interface Group {
  name: string;
  colour: string;
  label: Texts;
  constructors: Constructor[];
}

export interface Parameter {
  name: string;
  kind: "integer" | "boolean";
  min: number;
  max: number;
  default: number;
  unit: string;
  label: Texts;
  help: Texts;
}

export interface Method {
  name: string;
  kind: "procedure" | "test" | "value";
  label: Texts;
  help: Texts;
  icon: string;
  parameters: Parameter[];
  completes_later: boolean;
  stop: string | null;
  /** Words for a chip, with holes: "{object} = {value}". */
  phrase: Texts;
}

export interface RobotObject {
  name: string;
  category: "actuator" | "sensor" | "variable" | "system";
  device: string;
  icon: string;
  label: Texts;
  help: Texts;
  methods: Method[];
  type: "integer" | "boolean";
  min: number;
  max: number;
  initial: number;
  shared: boolean;
}

export interface Robot {
  name: string;
  label: Texts;
  help: Texts;
  tick_ms: number;
  wait_unit_ms: number;
  objects: RobotObject[];
  /** How long it is; 0 for one without wheels. */
  length_mm?: number;
}

export interface Catalogue {
  groups: Group[];
  robots: Robot[];
  problems: Problem[];
}

export interface Note {
  text: string;
  at: string;
}

export interface Vertex {
  id: string;
  element: string;
  settings: Record<string, string>;
  notes: Note[];
}

export interface Arc {
  source: string;
  target: string;
  out: string;
  at: string;
}

export interface Program {
  name: string;
  robot: string;
  vertices: Vertex[];
  arcs: Arc[];
}

export interface Agent {
  name: string;
  program: string;
  start: string;
}

export interface Goal {
  storehouse: string;
  stock: string;
}

/** A variable that the mission adds to every robot of a kind. */
export interface OwnVariable {
  robot: string;
  variable: RobotObject;
}

/** Where a run pauses: when one of `agents` (all that run the program where it is empty) comes to the vertex. */
export interface Breakpoint {
  program: string;
  vertex: string;
  agents?: string[];
  /** Whether all of them must stand there. */
  every?: boolean;
  /** A condition of LLL. */
  when?: string;
  /** The first visit that counts. */
  hits?: number;
  enabled?: boolean;
}

export interface ScheduledFailure {
  agent: string;
  at_s: number;
  kind: "fail" | "stall" | "mute" | "revive";
}

export interface Mission {
  version: 1;
  programs: Program[];
  agents: Agent[];
  goals: Goal[];
  world: string;
  /** The title and what happens, by language. */
  label?: Texts;
  help?: Texts;
  /** The parts that it brings along (own.ts). */
  constructors?: Constructor[];
  variables?: OwnVariable[];
  /** How it is tried out. */
  breakpoints?: Breakpoint[];
  failures?: ScheduledFailure[];
  /** The world that it brings along (model/world); it counts in the place of `world`. */
  own_world?: OwnWorld | null;
}

export type FloorColour = "red" | "green" | "blue";

export interface Corner {
  x: number;
  y: number;
  radius: number;
}

/** A world by what it is made of, so that it can be changed: parts of it may not fit together. Headings in degrees. */
export interface OwnWorld {
  name: string;
  width_mm: number;
  height_mm: number;
  walls: { x1: number; y1: number; x2: number; y2: number }[];
  floors: { colour: FloorColour; points: Corner[] }[];
  lines: { colour: FloorColour; width_mm: number; closed: boolean; points: Corner[] }[];
  roads: {
    name: string;
    width_mm: number;
    closed: boolean;
    points: Corner[];
    /** `to_mm` is null where a section ends with its road. */
    sections: { sign: number; from_mm: number; to_mm: number | null }[];
  }[];
  storehouses: World["storehouses"];
  docks: {
    name: string;
    road: string;
    at_mm: number;
    reach_mm: number;
    storehouse: string;
    kind: "load" | "unload";
    side: "left" | "right";
  }[];
  starts: {
    name: string;
    /** Which of the other fields count. */
    at: "pose" | "road" | "dock" | "storehouse";
    road: string;
    at_mm: number;
    dock: string;
    storehouse: string;
    x_mm: number;
    y_mm: number;
    heading_deg: number;
  }[];
  /** XML that nobody knows, kept word for word. */
  unknown: string[];
  label: Texts;
  help: Texts;
}

/** The one right answer to a problem: `text` for its place, and what that is in a graph. */
export interface Fix {
  text: string;
  kind: "text" | "element" | "setting" | "unset" | "unwrap" | "before";
  name: string;
}

export interface Problem {
  file: string;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  severity: "error" | "warning" | "hint";
  code: string;
  message: string;
  help: string;
  program: string;
  vertices: string[];
  arcs: [string, string, string, string][];
  /** A thing of the world: its kind and its number from 0, "road:0". */
  thing?: string;
  fix?: Fix | null;
}

export interface SpanEntry {
  vertex: string;
  start: number;
  end: number;
  line: number;
}

export interface ProgramReport {
  name: string;
  lll: string;
  spans: SpanEntry[];
  listing: string;
  instructions: number;
  /** The server's name of the program (api/known.ts). */
  known?: string;
}

/** What a pasted text became; null when it is no LLL. */
export interface Fragment {
  program: Program | null;
  problems: Problem[];
}

export interface Report {
  programs: ProgramReport[];
  problems: Problem[];
}

export interface World {
  name: string;
  width_mm: number;
  height_mm: number;
  walls: { x1: number; y1: number; x2: number; y2: number }[];
  floors?: { colour: "red" | "green" | "blue"; points: [number, number][] }[];
  lines?: { colour: "red" | "green" | "blue"; width_mm: number; closed: boolean; points: [number, number][] }[];
  roads: {
    name: string;
    width_mm: number;
    closed: boolean;
    points: [number, number][];
    sections: { sign: number; from_mm: number; to_mm: number }[];
  }[];
  docks: {
    name: string;
    road: string;
    at_mm: number;
    reach_mm: number;
    storehouse: string;
    kind: "load" | "unload";
    x_mm: number;
    y_mm: number;
    heading_rad: number;
  }[];
  storehouses: {
    name: string;
    x_mm: number;
    y_mm: number;
    width_mm: number;
    height_mm: number;
    capacity: number;
    stock: number;
  }[];
  starts: { name: string; x_mm: number; y_mm: number; heading_rad: number }[];
}

export interface MissionFile {
  path: string;
  name: string;
  revision: string;
  mission: Mission;
  problems: Problem[];
  world: World | null;
  catalogue: Catalogue;
  /** The state of the XML files around it. */
  parts?: string;
}

/** A world that a mission can take place in; `href` is what the mission calls it, "" for the empty one. */
export interface WorldEntry {
  href: string;
  shipped: boolean;
  label: Texts;
  help: Texts;
  /** Null when its file is no good. */
  world: World | null;
  problems: Problem[];
}
