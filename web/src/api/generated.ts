/**
 * What travels between the server and the page.
 *
 * Written by `python tools/api_types.py` from the models in `src/kitrobot/wire`: change those instead.
 */

/** A part of a robot, as it is called, and its picture. */
export type Ability = { icon: string; label: Record<string, string> };

/** A part of a robot that a kit has nothing for. */
export type AbsentPart = { category: "actuator" | "sensor"; name: string };

/** What can vary: its address, what stands there ("" for nothing), what can, and some values to begin with. */
export type Address = { address: string; current: string; expected: string; example: string };

/** The constructor, and its slot, that a branch adds itself to. */
export type Adds = { constructor: string; slot: string };

/** The name of a question to the teacher. */
export type AdmissionRequest = { asked: string };

/**
 * A member of the team and the program it runs. It starts at the world's start `start`, or the one of its name. `robot`
 * is its kind where its program is one of the level social, which speaks of all kinds.
 */
export type Agent = { name: string; program: string; start: string; robot?: string };

/**
 * What an agent does: where its threads stand, its variables and sensors, what its displays and the like show. `active`
 * are vertices of its program by slot, `inner` slot, program and vertex in others that stand in it. `used`: the parts
 * that have shown something in this run, also between two messages.
 */
export interface AgentReport {
  active: [number, string][];
  inner?: [number, string, string][];
  state: "running" | "waiting" | "idle" | "failed" | "stalled";
  values: Record<string, number>;
  inputs: Record<string, number>;
  shown: Record<string, number[]>;
  used?: string[];
  fault: number;
  forced: string[];
}

/** The result of checking one property. */
export type Answer = "holds" | "broken" | "not finished" | "vacuous" | "nothing found" | "not decided";

/** From a port of one vertex to a port of another. */
export type Arc = { source: string; target: string; out: string; at: string };

/** What the page of the pupil whom the teacher looks on shows of its run; null for none. */
export type ArenaMessage = { type: "arena"; folder: string; arena: ClassArena | null };

/**
 * One property. Attributes: name: its name in the mission. form: how it speaks of its conditions. first: the condition
 * of its first attribute; of a form with a list, all of them with semicolons between them. second: the condition behind
 * *eventually*, *until*, *before* or *while*; "" where there is none. seconds: the time behind *within* or *for*, in
 * simulated seconds; 0 where there is none. times: how often at most; 0 where the form does not say. order: of a visit.
 */
export interface AskedProperty {
  name: string;
  form: Form;
  first: string;
  second?: string;
  seconds?: number;
  times?: number;
  order?: VisitOrder;
}

/** A ball that can be pushed, around its middle; friction is what slows it down (0: it rolls for ever). */
export type Ball = { x_mm: number; y_mm: number; radius_mm: number; mass_g: number; friction: number };

/** A world to begin in. */
export interface BeginningPlace {
  name: string;
  label: Record<string, string>;
  help: Record<string, string>;
  world: World;
}

/** All there is to choose from. The starter `nothing`, without parts, fits every set in each of its places. */
export type Beginnings = { robot_sets: RobotSet[]; places: BeginningPlace[]; starters: Starter[] };

/** A part that the kit lacks or that cannot work there. */
export type BenchLeftOut = { part: string; label: Record<string, string>; why: string };

/**
 * One thing to try, in texts by language: what is to be seen, and what to look for when it does not happen. `call` is
 * what the part is told, "" for a sensor, whose value is looked at and means what `reads` says.
 */
export interface BenchStep {
  part: string;
  label: Record<string, string>;
  call: string;
  reads: Reading;
  seen: Record<string, string>;
  trouble: Record<string, string>;
}

/**
 * Parts that are tried: the `step` that is done now, None for none; `value` of its sensor, None before; whether its
 * driver is `slow` and takes longer than a tick.
 */
export type BoardBench = { step: number | null; value: number | null; slow: boolean; failed: BoardBenchFailure[] };

/** The part of a step is broken, and why. */
export type BoardBenchFailure = { step: number; message: string; help: string };

/**
 * Put the program that tries parts on the robot: those of the robot that the program is for. The answer is a message
 * with the steps; what becomes of them is told with the robot.
 */
export interface BoardBenchRequest {
  type: "bench";
  address: string;
  mission: Mission;
  path: string;
  program: string;
  kit?: string;
  replace?: boolean;
}

/** Break off the sending; the robot keeps the program that it had. */
export type BoardCancelRequest = { type: "cancel"; address: string };

/**
 * Greet the robot at that address. `mission` and `program` are what this page has open: when the robot has that
 * program, what it does is told by its names.
 */
export interface BoardConnectRequest {
  type: "connect";
  address: string;
  mission: Mission;
  path: string;
  program: string;
  kit?: string;
}

/** Why the robot stopped by itself; `vertex` and `line` (of the LLL, from 1) are "" and 0 where nobody knows. */
export interface BoardFault {
  number: number;
  sentence: string;
  text: string;
  program: string;
  vertex: string;
  line: number;
  tick: number;
}

/**
 * The bytes of the file in base64, the ending of its name, the boards that it is for, what is done with it, and why it
 * is not for another board.
 */
export type BoardFile = { file: string; ending: ".hex" | ".uf2"; boards: string; steps: string; reasons: string[] };

/**
 * Which program of a mission is to become a file, on which kit, "" as its robot's own file says. `firmware`: the bytes
 * of the UF2 file that comes along in base64, "" for a micro:bit; `firmware_name`: of that file.
 */
export interface BoardFileAsk {
  mission: Mission;
  path: string;
  program: string;
  kit: string;
  firmware: string;
  firmware_name: string;
}

/** Let go of the robot; one that is held stops. */
export type BoardForgetRequest = { type: "forget"; address: string };

/** Nobody talks with that robot any more. */
export type BoardGoneMessage = { type: "gone"; address: string };

/** Let the robot show which one it is. */
export type BoardIdentifyRequest = { type: "identify"; address: string };

/**
 * A robot as it stands. `package` and `installed` name what is on it; `program` is the name of that in the mission, ""
 * when it is not what the page sent or has open. What its program does is told as a run (`RobotsRequest`).
 */
export interface BoardMessage {
  type: "board";
  address: string;
  name: string;
  holder: string;
  phase: "closed" | "connecting" | "open" | "sending" | "lost";
  state: "none" | "ready" | "running" | "ended" | "fault";
  held: boolean;
  free: number;
  generation: number;
  package: string;
  installed: string;
  program: string;
  progress: BoardProgress | null;
  fault: BoardFault | null;
  message: string;
  help: string;
  way: "" | "replace" | "fresh";
  micropython: string;
  recorded: boolean;
  bench: BoardBench | null;
}

/** A port of this machine where a robot may be; `firmware`: the page with its MicroPython, "" for none. */
export type BoardPort = { address: string; name: string; description: string; firmware: string };

/** All ports there are now. */
export type BoardPortsMessage = { type: "ports"; ports: BoardPort[] };

/** How far the sending is: `done` of `total` bytes. */
export type BoardProgress = { step: "connect" | "reset" | "compare" | "send" | "start"; done: number; total: number };

/**
 * A request that was not followed; `problems` are those of the program that was to be sent. Of a team's requests
 * `address` is `team`.
 */
export interface BoardRefusedMessage {
  type: "refused";
  address: string;
  message: string;
  help: string;
  problems: Problem[];
}

/** Put that program on the robot, then let it run: held by this page, free, or not at all. */
export interface BoardSendRequest {
  type: "send";
  address: string;
  mission: Mission;
  path: string;
  program: string;
  kit?: string;
  then: "held" | "free" | "ready";
  replace?: boolean;
  fresh?: boolean;
}

/** Begin the program that is on the robot: held (it stops when this page goes away), or free. */
export type BoardStartRequest = { type: "start"; address: string; held: boolean };

/** What can be tried of the robot at that address. */
export type BoardStepsMessage = { type: "steps"; address: string; steps: BenchStep[]; left_out: BenchLeftOut[] };

/** Stop the robot, or with "" every robot that the studio knows. Any page may. */
export type BoardStopRequest = { type: "stop"; address: string };

/** Do that step (its place among the steps) until the next request; None: end it. */
export type BoardTryRequest = { type: "try"; address: string; step: number | null };

/** Tell which ports there are, and what is plugged in or out, from now on; or no more. */
export type BoardsLookRequest = { type: "look"; on: boolean };

/** The first message: by what name this page holds robots, and by which key ports that it opens itself. */
export type BoardsWelcomeMessage = { type: "welcome"; you: string; key: string };

/** A box that can be pushed, around its middle; friction is that of its underside (0: it slides for ever). */
export type Box = { x_mm: number; y_mm: number; width_mm: number; height_mm: number; mass_g: number; friction: number };

/** The rule, and after how many simulated seconds a robot is towed. */
export type Breakdown = { rule: BreakdownRule; after_s?: number };

/** It stays where it is; it is towed away, and its box goes back; the others drive round it. */
export type BreakdownRule = "stay" | "tow" | "pass";

/**
 * Where a run pauses. `agents` are those it watches, all that run the program when empty; with `every` it pauses only
 * when all of them stand there. `when` is a condition of LLL, tested with what that agent knows; it pauses at the visit
 * number `hits` and at each one after it.
 */
export interface Breakpoint {
  program: string;
  vertex: string;
  agents?: string[];
  every?: boolean;
  when?: string;
  hits?: number;
  enabled?: boolean;
}

/** Pause at these from now on. */
export type BreakpointsRequest = { type: "breakpoints"; breakpoints: Breakpoint[] };

/** Every word that programs can be made of, and what was wrong with the files that hold them. */
export interface Catalogue {
  groups: Group[];
  robots: Robot[];
  problems: Problem[];
  work?: RobotObject | null;
  own_label?: Record<string, string>;
}

/** What part of a robot an object is. */
export type Category = "actuator" | "sensor" | "variable" | "system";

/** What is known of the last moment. */
export type Certainty = "last" | "always" | "never" | "unknown";

/** A request to look a mission through; `path` is the file it was opened from, "" for a new one. */
export type Check = { mission: Mission; path: string };

/** One event of a run that breaks a property, and the step it is in. */
export type CheckedEvent = { step: number; text: string };

/** One answer: see `kitrobot.checking.background_check.PropertyAnswer`. */
export interface CheckedProperty {
  name: string;
  sentence: string;
  answer: Answer;
  steps: number;
  repeats_from: number;
  events: CheckedEvent[];
  left_out: number;
  confirmed: ConfirmingRun | null;
  searched: boolean;
  scenes: Scene[];
  guilty: Guilty[];
  places: number[];
  why: Why | null;
}

/** A value with a name, and one picture at most: an icon, five by five lights (digits 0 to 9), or a `#rrggbb`. */
export type Choice = { value: number; label: Record<string, string>; icon?: string; lights?: string; colour?: string };

/** An offer that is to be a slot, under a name for people. Numbers with one name become one slot. */
export interface ChosenSlot {
  vertex: string;
  slot: string;
  name: string;
  min?: number | null;
  max?: number | null;
  default?: string | null;
  unit?: string | null;
}

/** The journal that a tab writes from now on, and what is in it: nothing when `records` is empty. */
export type ClaimedJournal = { journal: string; path: string; name: string; records: string[]; damaged: boolean };

/** What anybody may know of a class: its name, and whether a code lets new pupils in. */
export type Class = { name: string; joining: boolean };

/** The answer: not yet, in with the key, or no. */
export type ClassAnswered = { state: "waiting" | "in" | "no"; key?: string };

/**
 * What a pupil's page shows of its run: the world, where each robot is (mm, mm, rad), the way of the first of them, and
 * the time of the run.
 */
export interface ClassArena {
  running: boolean;
  seconds: number;
  world: World;
  poses: [number, number, number][];
  way: [number, number][];
}

/** Somebody asks to be let in as that pupil. */
export type ClassAsking = { asked: string; folder: string; name: string };

/** A goal of the exercise of the class, by language. */
export type ClassGoalName = { label: Record<string, string> };

/** The class as a whole; each time something of it changed. `kept_s`: how long ago work came in last. */
export interface ClassNewsMessage {
  type: "class";
  name: string;
  folder: string;
  code: string;
  address: string;
  qr: string[];
  reach: string;
  frozen: boolean;
  places: number;
  exercise: string;
  exercise_label: Record<string, string>;
  goals: ClassGoalName[];
  asking: ClassAsking[];
  grading: GradingState | null;
  bytes: number;
}

/** What a card's picture is drawn from: the first program that an agent runs. */
export type ClassPicture = { version: number; program: Program };

/** A line on the floor; `colour` is a key of `COLOURS`. */
export type ColouredLine = { colour: "red" | "green" | "blue"; width_mm: number; points: Corner[]; closed: boolean };

/** What befell an agent in a run of the simulator. */
export type ConfirmingFailure = { agent: string; at_s: number; kind: "fail" | "stall" | "mute" | "revive" };

/**
 * A run of the simulator that breaks a property: the run of the same mission with that seed and these failures on its
 * schedule, which breaks it in step `tick`, at `seconds`.
 */
export type ConfirmingRun = { seed: number; tick: number; seconds: number; failures: ConfirmingFailure[] };

/** The file is not what the page last saw; `revision` is what it is now. */
export type Conflict = { message: string; help: string; revision: string };

/**
 * What both changed differently: what it is, what became of it, and both values in words, "" where they are long.
 * `taken`: the file's is taken. `open`: there is something to decide.
 */
export interface Conflicted {
  name: string;
  what: string;
  sentence: string;
  ours: string;
  theirs: string;
  taken: boolean;
  open: boolean;
}

/** A building block of programs. */
export interface Constructor {
  name: string;
  group: string;
  icon: string;
  colour: "loop" | "choice" | "parallel" | "action" | "test" | "team";
  label: Record<string, string>;
  help: Record<string, string>;
  slots: Slot[];
  role: Role;
  adds: Adds | null;
  code: string;
  level?: Level;
  order?: number;
  words?: Record<string, string[]>;
}

/** A point of a line as people give it; a radius rounds it off. */
export type Corner = { x: number; y: number; radius: number };

/** Why the exploration, or a later search of the state space, ended early. */
export type CutReason = "states" | "memory" | "time" | "stopped" | "size";

/** What the text of a team's program declares before its instructions. */
export type Declared = { roles: TeamRole[]; groups: TeamGroup[]; works: Work[] };

/** What is different in the mission from its file, a sentence each; `revision` is the file's. */
export type Difference = { revision: string; changes: string[] };

/**
 * Where a carrier stands to be loaded or unloaded: within `reach_mm` of `at_mm` along its road. `side` is that of the
 * road.
 */
export interface Dock {
  name: string;
  road: string;
  at_mm: number;
  reach_mm: number;
  storehouse: string;
  kind: "load" | "unload";
  side: "left" | "right";
}

/** Where stock goes from a storehouse onto a carrier, or back. */
export interface DockPose {
  name: string;
  road: string;
  at_mm: number;
  reach_mm: number;
  storehouse: string;
  kind: "load" | "unload";
  x_mm: number;
  y_mm: number;
  heading_rad: number;
}

/**
 * What pens drew: of the marks that were told before, the first `keep` stay, and `marks` come after them. A line that
 * has not ended goes on to where its robot is.
 */
export type Drawing = { keep: number; marks: [number, 1 | 2 | 4, number, number, number, number][] };

/** What was found: all there is to tell. */
export type DrawingCheckMessage = { type: "found"; findings: DrawingFinding[] };

/** A problem, and the run of the simulator that shows it, if one does. */
export type DrawingFinding = { problem: Problem; shown: ConfirmingRun | null };

/** A drive that takes firmware; `board` as it names itself, `chip` "" where that says nothing. */
export type Drive = { folder: string; board: string; chip: string };

/** A request that could not be followed; `ended` when there is no run any more because of it. */
export type ErrorMessage = { type: "error"; message: string; help: string; ended: boolean };

/**
 * What is told of an example: its level from 1, 0 where nobody said one; the kinds of its robots; how many there are,
 * and how many parts its first program has.
 */
export type Example = { level: number; topics: Topic[]; robots: string[]; agents: number; parts: number };

/**
 * An exercise; `start` is the mission it begins with, `order` its place on the path to learn, `seconds` how long each
 * run may take, `seeds` are those of its runs. One that cannot be used has no goals but `problems`.
 */
export interface Exercise {
  name: string;
  start: string;
  label: Record<string, string>;
  help: Record<string, string>;
  icon: string;
  order: number;
  seconds: number;
  seeds: number[];
  goals: ExerciseGoal[];
  problems: Problem[];
}

/**
 * A goal; `kind` is what it is decided from. `watched` is a property that only runs can judge; where no check of a
 * mission can, runs judge a `check` too.
 */
export type ExerciseGoal = { label: Record<string, string>; kind: "program" | "run" | "check" | "watched" };

/** A study that is asked for; `seconds` is the longest simulated time of a run, `fail_rate` (0…1) as in a run. */
export interface ExperimentAsk {
  mission: Mission;
  path: string;
  axes: ExperimentAxis[];
  seeds: string;
  measures: string[];
  seconds?: number;
  fail_rate?: number;
}

/** An address, and its values as text: a list, a range or a design. */
export type ExperimentAxis = { address: string; values: string };

/** What a mission has for an experiment: addresses, measures, and the studies of it so far, the newest first. */
export type ExperimentChoices = { addresses: Address[]; measures: string[]; studies: StudyEntry[] };

/** What a study would be: how many points and runs, and the command line that does the same. */
export type ExperimentPlan = { points: number; runs: number; command: string };

/**
 * How many runs are over, of how many; about how many seconds are left, None while nobody knows; the study so far, now
 * and then.
 */
export interface ExperimentProgressMessage {
  type: "progress";
  done: number;
  total: number;
  left_s: number | null;
  study: Study | null;
}

/** Go on with a study that lies beside the mission of that path. */
export type ExperimentResumeRequest = { type: "resume"; path: string; study: string };

/** The study when the work on it ended, complete or broken off. */
export type ExperimentStudyMessage = { type: "study"; study: Study };

/** What happens to an agent, and when, in simulated seconds. */
export type Failure = { agent: string; at_s: number; kind: FailureKind };

/**
 * What happens to an agent: it stops for good, misses its ticks, loses its radio, is well again, or is cut off: it
 * hears, and is heard by, only those that are cut off too.
 */
export type FailureKind = "fail" | "stall" | "mute" | "revive" | "apart";

/** The drives that there are now; `page`: where MicroPython for most boards is to be had. */
export type Firmware = { page: string; drives: Drive[] };

/** A request for a program of the whole team, of that name, for a mission that has none. */
export type FirstTeam = { mission: Mission; path: string; name: string };

/** The one right answer: `text` for the place, and what that is in a graph. */
export type Fix = { text: string; kind: "text" | "element" | "setting" | "unset" | "unwrap" | "before"; name: string };

/** A firmware that was copied: the board as it names itself, and the version, "" for no MicroPython. */
export type Flashed = { board: string; micropython: string };

/**
 * Run this mission as a team of processes, some of whose agents have a board: `holder` is the page's name among those
 * with robots. It goes on in real time whatever is shown of it, and ends with this socket.
 */
export interface FleetRequest {
  type: "fleet";
  mission: Mission;
  path: string;
  holder: string;
  boards: TeamBoard[];
  seed: number;
  speed: number;
  breakpoints?: Breakpoint[];
}

/**
 * A coloured part of the floor inside `corners`, rounded where they have a radius; `colour` is a key of `COLOURS`.
 * Where its border crosses itself, what is enclosed twice is not coloured.
 */
export type Floor = { colour: "red" | "green" | "blue"; points: Corner[] };

/** A coloured part of the floor, by the points of its border, sampled like a road. */
export type FloorOutline = { colour: "red" | "green" | "blue"; points: [number, number][] };

/**
 * The program of a text, with the place of each vertex in it; None, and no places, while it has mistakes. `spans` and
 * `problems` are None where they are those of the report: the text is the one that the graph prints. `problems` have
 * their places in the text that was sent. `report` is the mission looked through with that program, and with what the
 * text of a team's program declares: `declared`.
 */
export interface Followed {
  program: Program | null;
  spans: SpanEntry[] | null;
  problems: Problem[] | null;
  report: Report | null;
  declared?: Declared | null;
}

/** Put a value in the place of what a sensor measures; null gives the sensor back. */
export type ForceRequest = { type: "force"; agent: string; sensor: string; value: number | null };

/** How a property speaks of its conditions; the value names the first attribute of its form. */
export type Form = "never" | "after" | "eventually" | "stays" | "holds" | "at-most" | "first" | "again" | "visit";

/** What the text became: a chain from Start to Stop, or a condition on its own; None when it is no LLL. */
export type Fragment = { program: Program | null; problems: Problem[] };

/** What must be true in the end: that many boxes (0…65535 in figures, or `ALL`) in a storehouse. */
export type Goal = { storehouse: string; stock: string };

/** A goal of the exercise as the pupil's page judged it; None: not yet. */
export type GoalReport = { reached: boolean | null; why?: string };

/**
 * What came of a goal; `reached` is null where this piece says nothing of it. `why` is what went wrong, or how a check
 * knows that it is reached. `seed` and `seconds` are the run and the moment that show what went wrong.
 */
export type GoalVerdict = { reached: boolean | null; why: string; seed: number | null; seconds: number | null };

/** How far grading is; `page` names what it wrote, "" until then. */
export type GradingState = { done: number; total: number; page: string };

/** A tab of the palette. `holds`: which parts of a robot that say no group are in it too. */
export interface Group {
  name: string;
  colour: "loop" | "choice" | "parallel" | "action" | "test" | "team";
  label: Record<string, string>;
  icon?: string;
  holds?: "" | "actuators" | "sensors" | "values";
  constructors: Constructor[];
}

/** A vertex at which a property is broken, whose robot, what happens there, and whether it goes on for ever. */
export type Guilty = { agent: string; program: string; vertex: string; sentence: string; repeats: boolean };

/** A stored submission: its name, which may differ from the requested one, and its revision. */
export type HandIn = { name: string; revision: string };

/** The pupil asks for help, or does not any more. */
export type HandMessage = { type: "hand"; up: boolean };

/** Let an agent fail for good, miss its ticks or lose its radio, or make it well again. */
export type HarmRequest = { type: "harm"; agent: string; kind: "fail" | "stall" | "mute" | "revive" | "apart" };

/** The first message of `WS /api/watch`: the name of the page's tab. */
export type HelloMessage = { type: "hello"; tab: string };

/** The answer to whatever the page says: the studio answers questions. */
export type HereMessage = { type: "here" };

/** An agent came to the vertex of a breakpoint. `visit` counts from 1. */
export type Hit = { program: string; vertex: string; agent: string; visit: number };

/** A program without errors, compiled: the bytes of its `.kri` in base64, and the text of its `.kra`. */
export type Image = { image: string; listing: string };

/** The code of the class and the pupil's name; `word` from another computer. */
export type Join = { code: string; name: string; word?: string };

/** In, with the key that every later request brings along; or there is a pupil of that name already. */
export type Joined = { state: "in" | "taken"; key?: string; name?: string; word?: string };

/** A whole journal, to take the place of the one that the page writes; without records there is none any more. */
export type Journal = { tab: string; path: string; name: string; records: string[]; unsaved: boolean };

/** How large the journal is now. */
export type JournalSize = { bytes: number };

/**
 * A mission to be judged by an exercise: its programs and the run of `seed`; without one, what is checked. `judging` is
 * a name by which it can be stopped.
 */
export type Judge = { exercise: string; mission: Mission; seed?: number | null; judging?: string };

/** What came of each goal, in order; `mission` is what was judged: the programs in the exercise's mission. */
export type Judged = { goals: GoalVerdict[]; mission: Mission };

/**
 * What is said of a property of the mission: `name` is its own, `sentence` what it demands, `reason` the ground.
 * `tick`: the tick in which it broke; null where there is no such moment.
 */
export interface Judgement {
  name: string;
  sentence: string;
  ruling: "kept" | "broken" | "not decided";
  reason: string;
  tick: number | null;
}

/**
 * A run of the simulator that keeps a property, the same as the one that breaks it up to step `tick`, at `seconds`: the
 * agent `delayed` waits `delay_s` there, or failures are missing ("").
 */
export interface KeptRun {
  seed: number;
  tick: number;
  seconds: number;
  failures: ConfirmingFailure[];
  delayed: string;
  delay_s: number;
  ends_well: boolean;
}

/** What a method gives: an instruction, true or false, or a number. */
export type Kind = "procedure" | "test" | "value";

/**
 * What a robot can be built of; `micropython` is the least version that it needs, "" for any, and `firmware` the page
 * where its file says that it is to be had. `file` is the ending of the file that its board takes from its drive, ""
 * for none. `picture` is an SVG of it, drawn from its file. `absent` are the parts that the kit has nothing for, by the
 * robot whose parts they are.
 */
export interface KitEntry {
  name: string;
  label: Record<string, string>;
  help: Record<string, string>;
  micropython: string;
  firmware: string;
  file: "" | ".hex" | ".uf2";
  picture: string;
  absent: Record<string, AbsentPart[]>;
}

/**
 * Whether a program runs on a kit, "" as its robot's own file says: the used parts that the kit lacks, and why the
 * program cannot be sent, "" when it can.
 */
export type KitFit = { kit: string; missing: Lacking[]; problem: string };

/** A part of a robot that a kit lacks; its label is by language. */
export type Lacking = { part: string; label: Record<string, string> };

/** Of whom a program speaks. What a level can say the ones behind it can say too. */
export type Level = "agent" | "group" | "social";

/** A coloured line on the floor, sampled like a road. */
export interface LineOutline {
  colour: "red" | "green" | "blue";
  width_mm: number;
  closed: boolean;
  points: [number, number][];
}

/** The teacher looks on, or at nobody. */
export type LookMessage = { type: "look"; folder: string };

/** Of a run with very many agents: tell what these do; others are told only as poses. */
export type LookRequest = { type: "look"; agents: string[] };

/**
 * A mark of one exercise. Attributes: exercise: the name of the exercise in the class. label: what it is called, in
 * English. points: what was earned, from 0 to `of`; None before it is graded, and where the work cannot be judged. of:
 * the points of all its goals; 0 while it is not known. comment: what the teacher wrote, on one line; "" for nothing.
 */
export type Mark = { exercise: string; label: string; points: number | null; of: number; comment: string };

/**
 * What a number means. `scale`: how many units one is, a decimal number above 0 or `WAIT_UNIT`. `units`: the unit in
 * other languages than English, whose word stands beside the number.
 */
export interface Meaning {
  scale?: string;
  units?: Record<string, string>;
  field?: "" | "slider" | "time" | "dial" | "ruler" | "choices" | "lights" | "piano" | "colour";
  choices?: Choice[];
}

/**
 * A place of a team's program at which robots wait for others: who is there, who is missing, how many of how many.
 * `vertex` is "" where there is none.
 */
export interface Meeting {
  point: number;
  program: string;
  vertex: string;
  here: string[];
  missing: string[];
  here_count: number;
  count: number;
}

/** A robot of a team: its role ("" while it is spare), groups, in whose place it stands, whether it is missed. */
export type Member = { name: string; role: string; groups: string[]; stands_for: string; missed: boolean };

/** A mission with the edits of its file, and what both changed differently. `theirs` is that revision. */
export type Merged = { revision: string; mission: Mission; theirs: Mission; conflicts: Conflicted[] };

/** What a robot object can do or tell. `phrase`: words for chips, with holes, `{object} = {value}`. */
export interface Method {
  name: string;
  kind: Kind;
  label: Record<string, string>;
  help: Record<string, string>;
  icon: string;
  parameters: Parameter[];
  completes_later: boolean;
  stop: string | null;
  phrase: Record<string, string>;
  test?: "" | "equal" | "less" | "greater";
  to?: number | null;
  alone?: boolean;
  group?: string;
  order?: number;
  words?: Record<string, string[]>;
}

/**
 * All of a `.krt`; `world` is the name of a world's file, "" for the empty world; `own_world` counts instead. `unknown`
 * is XML of the file that nobody knows, kept word for word; `prolog` are comments and instructions before its first
 * element, whose attributes with a prefix are in `attributes`; `label` and `help` are the title and what happens, by
 * language.
 */
export interface Mission {
  version: 1;
  programs: Program[];
  agents: Agent[];
  goals: Goal[];
  world: string;
  unknown?: string[];
  label?: Record<string, string>;
  help?: Record<string, string>;
  constructors?: Constructor[];
  variables?: OwnVariable[];
  breakpoints?: Breakpoint[];
  failures?: Failure[];
  breakdown?: Breakdown | null;
  properties?: AskedProperty[];
  own_world?: OwnWorld | null;
  radio?: Radio | null;
  roles?: TeamRole[];
  groups?: TeamGroup[];
  works?: Work[];
  prolog?: string[];
  attributes?: Record<string, string>;
}

/**
 * A mission that can be opened; `modified` is a moment in UTC (ISO 8601). `problem` is why it cannot be opened, ""
 * where nothing is known against it. Examples are read-only and say more: title (`label`) and what happens (`help`) by
 * language, and `example`.
 */
export interface MissionEntry {
  path: string;
  name: string;
  title: string;
  modified: string;
  label: Record<string, string>;
  help: Record<string, string>;
  example: Example | null;
  problem: string;
}

/**
 * A mission opened; `revision` names the content that was read, "" when there is no file yet. `parts` names the state
 * of the XML files around it, as `NewsMessage` does.
 */
export interface MissionFile {
  path: string;
  name: string;
  revision: string;
  mission: Mission;
  problems: Problem[];
  world: World | null;
  catalogue: Catalogue;
  parts?: string;
}

/**
 * What is on disk for the page's mission ("" when nothing is), and how many other pages have it open. `parts` names the
 * state of the XML files that the mission depends on: robots, constructors, its world. `runs` are the runs of the
 * mission that are on, on this page or another.
 */
export interface NewsMessage {
  type: "news";
  path: string;
  revision: string;
  others: number;
  parts: string;
  runs: string[];
}

/**
 * A comment of the user. `at` is "" for lines above the instruction, "after" for the rest of its line, "in:SLOT" for
 * the end of that body (a repeated slot with its number, `in:branch.2`). A plain note of Stop stands at the end of the
 * program.
 */
export type Note = { text: string; at: string };

/** What could be left open. `inside`: the offer that holds it; `is_open`: nothing fills it, so it has to be. */
export interface Offer {
  vertex: string;
  slot: string;
  kind: SlotKind;
  name: string;
  label: Record<string, string>;
  inside: Place | null;
  is_open: boolean;
  value: string;
  min: number;
  max: number;
  unit: string;
  meaning?: Meaning | null;
}

/** What a selection offers, or why it cannot be a part. */
export type OfferAnswer = { offered: Offered | null; refused: RequestFailure | null };

/** What a selection offers; `problems` are in it while nothing is left open. */
export type Offered = { role: Role; vertices: string[]; offers: Offer[]; problems: Problem[] };

/** Unsaved work that was left behind; `problem` is why it cannot be opened, "" where it can. */
export type OrphanedJournal = { journal: string; path: string; name: string; modified: string; problem: string };

/** A run that keeps a property from the deciding step on: see `kitrobot.checking.run_explanation.OtherWay`. */
export type OtherWay = { events: CheckedEvent[]; ends_well: boolean; scenes: Scene[] };

/** A road by its corners. */
export type OwnRoad = { name: string; width_mm: number; closed: boolean; points: Corner[]; sections: OwnSection[] };

/** A numbered stretch of a road; `to_mm` is None where it ends with its road. */
export type OwnSection = { sign: number; from_mm: number; to_mm: number | null };

/** Where an agent may start; `at` says which of the other fields count. */
export interface OwnStart {
  name: string;
  at: "pose" | "road" | "dock" | "storehouse";
  road: string;
  at_mm: number;
  dock: string;
  storehouse: string;
  x_mm: number;
  y_mm: number;
  heading_deg: number;
}

/** A variable that the mission adds to every robot of a kind. */
export type OwnVariable = { robot: string; variable: RobotObject };

/** All of a world; `unknown` is XML that nobody knows, kept; `attributes` are those with a prefix. */
export interface OwnWorld {
  name: string;
  width_mm: number;
  height_mm: number;
  walls: Wall[];
  floors: Floor[];
  lines: ColouredLine[];
  roads: OwnRoad[];
  storehouses: Storehouse[];
  docks: Dock[];
  starts: OwnStart[];
  boxes?: Box[];
  balls?: Ball[];
  zones?: Zone[];
  unknown: string[];
  label: Record<string, string>;
  help: Record<string, string>;
  attributes?: Record<string, string>;
}

/** One parameter of a method: whole numbers `minimum`…`maximum` (both included). */
export interface Parameter {
  name: string;
  min: number;
  max: number;
  default: number;
  kind: ValueType;
  unit: string;
  label: Record<string, string>;
  help: Record<string, string>;
  meaning?: Meaning | null;
}

/** The part, its LLL, and the program with a vertex of it in the selection's place. */
export type Part = { constructor: Constructor; lll: string; program: Program; vertex: string };

/** What a wish became, or why it cannot be. */
export type PartAnswer = { part: Part | null; refused: RequestFailure | null };

/**
 * The part (None while there are mistakes) and its LLL in the one true layout. `drawing` is its template as a graph,
 * whose holes are named `{name}`; problems have their places in the code as it was sent, those on line 0 are about the
 * rest.
 */
export type PartRead = { constructor: Constructor | null; lll: string; drawing: Program | null; problems: Problem[] };

/** A selection that is to be a part. */
export interface PartWish {
  mission: Mission;
  path: string;
  program: string;
  vertices: string[];
  name: string;
  icon?: string;
  colour?: "loop" | "choice" | "parallel" | "action" | "test" | "team";
  label?: Record<string, string>;
  help?: Record<string, string>;
  chosen: ChosenSlot[];
}

/** What the files around a mission hold; `stamp` names their state, as `parts` of `NewsMessage` does. */
export type Parts = { stamp: string; catalogue: Catalogue };

/** What is different in a kit's file from the one that is there, a sentence each; nothing where it is no kit. */
export type PartsDifference = { changes: string[] };

/**
 * A file that was put beside a mission: its name there, and the names that it brings along. `known` tells that the very
 * same file was there already.
 */
export interface PartsFile {
  file: string;
  kind: "robot" | "board" | "constructors" | "world";
  names: string[];
  known: boolean;
}

/** Stand still. */
export type PauseRequest = { type: "pause" };

/** A slot or parameter of a vertex; the slot "" is the vertex itself. */
export type Place = { vertex: string; slot: string };

/** A world's file as something that can be changed: None when it is not there or has mistakes, which are told. */
export type Plan = { world: OwnWorld | null; problems: Problem[] };

/**
 * Something of the page that a step points at: `kind` is an attribute of `<point>`, `name` its value. `inner` is a
 * setting or a slot of the vertex, or a rule on failure of the group; "" for the vertex or group itself.
 */
export type Point = { kind: "part" | "vertex" | "button" | "panel" | "program" | "group"; name: string; inner: string };

/** A step out of a state: see `kitrobot.verifier.report.state_walk.PossibleStep`. */
export interface PossibleStep {
  place: number;
  sentences: string[];
  is_failure: boolean;
  returns_to: number;
  breaks: string[];
}

/** A starter, and what its agents do in the first seconds. */
export type Preview = { starter: string; run: RunPreview };

/** An agent of a preview; `start` is the place in the world where it begins, "" where that has its own name. */
export type PreviewAgent = { name: string; program: string; robot: string; number: number; start: string };

/** From that frame on an agent's actuator shows these numbers. */
export type PreviewShown = { frame: number; agent: number; part: string; numbers: number[] };

/** From that frame on so many boxes lie in a storehouse. */
export type PreviewStock = { frame: number; storehouse: string; boxes: number };

/** A diagnostic; lines and columns count from 1 and are 0 where there is no file. */
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
  thing?: string;
  fix?: Fix | null;
}

/** The mission has errors and was not started. */
export type ProblemsMessage = { type: "problems"; problems: Problem[] };

/**
 * A graph, and what it is for: `target` names the kind of robot of the agents that run it, "" for a team's. Examples:
 */
export type Program = { name: string; robot: string; vertices: Vertex[]; arcs: Arc[]; level?: Level };

/** What a program becomes: LLL with the place of each vertex, and how long its three-address code is. */
export type ProgramReport = { name: string; lll: string; spans: SpanEntry[]; instructions: number };

/** What a team's program is for a kind of robot. */
export type ProjectionReport = { robot: string; lll: string; spans: ProjectionSpan[] };

/** A stretch of a projected program, as `VertexPlace`, and the team's program in which its vertex stands. */
export type ProjectionSpan = { program: string; vertex: string; start: number; end: number; line: number };

/**
 * A pupil as the overview shows them; `seconds` is how long the state lasts, where that counts. `version` is another
 * one with each picture, 0 while there is none; `frozen`: this pupil is to look up, alone or with everybody; `mark`: of
 * the exercise of the class.
 */
export interface Pupil {
  folder: string;
  name: string;
  word: string;
  state: "asks" | "stuck" | "running" | "editing" | "done" | "away";
  seconds: number | null;
  running: boolean;
  file: string;
  version: number;
  exercise: string;
  goals: GoalReport[];
  pages: number;
  frozen: boolean;
  turn: "pupil" | "asked" | "teacher";
  mark: Mark | null;
}

/**
 * What the pupil's page is to know. `handed` and `note` count: a higher number is a new one. `turn`: who edits, or that
 * the teacher asks to. `comments`: what the teacher wrote on exercises, by their names.
 */
export interface PupilNewsMessage {
  type: "pupil";
  class_name: string;
  name: string;
  word: string;
  frozen: boolean;
  exercise: string;
  handed: number;
  handed_name: string;
  note: number;
  note_text: string;
  looked: boolean;
  hand: boolean;
  turn: "pupil" | "asked" | "teacher";
  comments: Record<string, string>;
}

/** Pupils that changed since the last message, and who is gone; `kept_s`: seconds since work came in last. */
export type PupilsMessage = { type: "pupils"; changed: Pupil[]; gone: string[]; kept_s: number | null };

/**
 * `range_mm`: how far a robot is heard, from middle to middle, None for everywhere; `delay_ms`: how long a message
 * takes; `loss`: the part of all messages that gets lost, in %.
 */
export type Radio = { range_mm?: number | null; delay_ms?: number; loss?: number };

/** Where a range finder looks: how far from its robot's edge, in mm, and counter-clockwise from the front. */
export type Ray = { reach_mm: number; angle_rad: number };

/** What the value of a part means. */
export type Reading = { type: ValueType; unit: string; meaning: Meaning | null };

/**
 * A recording that was opened: its name, by which it is played, and the mission that it brought along. `cut`: its file
 * ends before its run did. `fail_rate` is the probability that an agent failed by chance within a minute. `real`: it is
 * of real robots.
 */
export interface Recording {
  recording: string;
  seed: number;
  fail_rate: number;
  cut: boolean;
  real: boolean;
  file: MissionFile;
}

/** A recording of the folder; `modified` is a moment in UTC (ISO 8601), `problem` why it cannot be opened. */
export type RecordingEntry = { path: string; name: string; modified: string; problem: string };

/** Play a recording that was opened; `recording` is its name. From its first step on it pauses at breakpoints. */
export type ReplayRequest = { type: "replay"; recording: string; speed: number; breakpoints?: Breakpoint[] };

/** A mission looked through. `projections`: one for each kind of robot that runs the program of the whole team. */
export type Report = { programs: ProgramReport[]; problems: Problem[]; projections?: ProjectionReport[] };

/** What the page says of itself. `edits` and `runs` count: another number is something that moved. */
export interface ReportMessage {
  type: "report";
  running: boolean;
  edits: number;
  runs: number;
  file: string;
  exercise: string;
  goals: GoalReport[];
}

/** Why a request could not be done: a sentence and a way out; `problems` where a file was the reason. */
export type RequestFailure = { message: string; help: string; problems?: Problem[] };

/** Go on; with `latest` from the latest tick, which with real robots is now. */
export type ResumeRequest = { type: "resume"; latest?: boolean };

/** A road as the line along its middle. */
export type Road = { name: string; width_mm: number; closed: boolean; points: [number, number][]; sections: Section[] };

/** A kind of robot; `length_mm` is how long it is, 0 for one without wheels, `figure` how it is drawn. */
export interface Robot {
  name: string;
  label: Record<string, string>;
  help: Record<string, string>;
  tick_ms: number;
  wait_unit_ms: number;
  objects: RobotObject[];
  length_mm?: number;
  figure?: string;
}

/** A part of a robot. In the arena, `look` is how an actuator is drawn, and `hand` how a person works a sensor. */
export interface RobotObject {
  name: string;
  category: Category;
  look?: "" | "wheels" | "lights" | "melody" | "pin" | "lamp" | "bar" | "sound" | "number" | "pen";
  hand?: "" | "button" | "gesture" | "slider";
  ray?: Ray | null;
  icon: string;
  label: Record<string, string>;
  help: Record<string, string>;
  methods: Method[];
  type: ValueType;
  min: number;
  max: number;
  initial: number;
  shared: boolean;
  unit?: string;
  meaning?: Meaning | null;
  group?: string;
  words?: Record<string, string[]>;
}

/** Robots to begin with; `places` are the names of those they fit, `can` and `feels` their actuators and sensors. */
export interface RobotSet {
  name: string;
  label: Record<string, string>;
  help: Record<string, string>;
  robots: string[];
  own: boolean;
  can: Ability[];
  feels: Ability[];
  places: string[];
}

/**
 * Watch and steer real robots that this page holds; `holder` is its name among those with robots, and `mission` is what
 * the programs of the robots are of. They run whatever is asked for; what is shown of them can be paused, and pauses at
 * the breakpoints.
 */
export interface RobotsRequest {
  type: "robots";
  mission: Mission;
  path: string;
  holder: string;
  addresses: string[];
  speed: number;
  breakpoints?: Breakpoint[];
}

/** Where a constructor stands: as an instruction, as a condition, or as one more branch of another. */
export type Role = "instruction" | "condition" | "branch";

/** Something worth a mark on the timeline. */
export interface RunEvent {
  tick: number;
  kind: "load" | "unload" | "message" | "collision" | "failure" | "revival" | "member" | "end" | "outside";
  agent: string;
  text: string;
  cause: "program" | "world" | "person" | "mission" | "chance" | "robot" | "link";
}

/**
 * The first seconds of a run in `frames` pictures; none where it cannot run, and then its program is what there is.
 * `ways`: of each agent five numbers a frame (x and y in mm, the heading in thousandths of a radian, load, flags); of
 * one that never changes only five. `things`: of each thing that can be pushed x and y, likewise. `marks`: points of
 * lines of pens, each (frame, pen, what, x, y, colour, width), and `pens` who has them.
 */
export interface RunPreview {
  program: Program | null;
  world: World | null;
  seconds: number;
  frames: number;
  agents: PreviewAgent[];
  ways: number[][];
  shown: PreviewShown[];
  stock: PreviewStock[];
  things: number[][];
  pens: number[];
  marks: number[][];
}

/**
 * The run between two steps: `run` in frames that are `frame_s` apart, and what happens in it. `ending` says why the
 * run ended in it; "" where it goes on behind it.
 */
export type RunStretch = { run: RunPreview; frame_s: number; events: StretchEvent[]; ending: string };

/** Record the run of a mission with that seed between two steps, `first` before `last`. */
export type RunStretchAsk = { mission: Mission; path: string; seed: number; first: number; last: number };

/** A mission to be written; `revision` is the one that the page last read or wrote, "" for a new file. */
export type Save = { path: string; revision: string; mission: Mission };

/** What was written; `locked`: whether nobody else could save meanwhile; not so where the folder knows no locks. */
export type Saved = { path: string; revision: string; locked?: boolean };

/** The picture before a step (the last one: after all steps). Robots are in the order of the team. */
export type Scene = { step: number; robots: SceneRobot[] };

/** One robot in a scene: its pose (mm, radians; rounded), and the vertices at which its program is. */
export type SceneRobot = { x_mm: number; y_mm: number; heading_rad: number; at: [string, string][] };

/** A stretch of a road with the number its signs show. */
export type Section = { sign: number; from_mm: number; to_mm: number };

/** Go to a tick that was run already, and pause there; one beyond the end goes to the end. */
export type SeekRequest = { type: "seek"; tick: number };

/** Some vertices of a program; `path` is the mission's file, "" for a new one. */
export type Selected = { mission: Mission; path: string; program: string; vertices: string[] };

/**
 * What the page starts with: the mission to open, and the name of the folder that missions are in. `secret` is what the
 * page knows the next studio of this folder by; it keeps it in its memory and never sends it.
 */
export type Session = { version: string; path: string | null; workspace: string; secret: string };

/** Set a variable of an agent. */
export type SetRequest = { type: "set"; agent: string; variable: string; value: number };

/** The run that the page shows, told while the teacher looks on. */
export type ShowArenaMessage = { type: "arena"; arena: ClassArena };

/**
 * A hole of a constructor. A `repeat` slot holds any number of bodies; `least` of them come with a new vertex. `names`
 * says what a text slot names: "set" (roles, groups and agents) or "program"; "" for anything else.
 */
export interface Slot {
  name: string;
  kind: SlotKind;
  loop: boolean;
  repeat: boolean;
  least: number;
  min: number | null;
  max: number | null;
  default: string;
  unit: string;
  label: Record<string, string>;
  names?: "" | "set" | "program";
  meaning?: Meaning | null;
}

/** What fills a slot: a chain of vertices, one test, a number or value vertex, typed text, one procedure call. */
export type SlotKind = "flow" | "condition" | "value" | "number" | "text" | "action";

/** The stretch of LLL that a vertex became: character offsets, the end exclusive, and the line from 1. */
export type SpanEntry = { vertex: string; start: number; end: number; line: number };

/** Run at another speed from now on. */
export type SpeedRequest = { type: "speed"; value: number };

/** Where an agent may start. */
export type StartPose = { name: string; x_mm: number; y_mm: number; heading_rad: number };

/**
 * Run this mission; `path` is the file it was opened from, "" for a new one. `fail_rate` is the probability that an
 * agent fails by chance within a minute, `seconds` the simulated time after which the run ends, null for never.
 */
export interface StartRequest {
  type: "start";
  mission: Mission;
  path: string;
  seed: number;
  speed: number;
  fail_rate?: number;
  seconds?: number | null;
}

/**
 * A robot of the run; the binary frames follow the order of this list. `placed`: whether it is known where it is; that
 * of a real robot is not, and its pose in the frames means nothing.
 */
export interface StartedAgent {
  name: string;
  program: string;
  robot: string;
  number: number;
  kind: string;
  placed: boolean;
}

/**
 * The run is on, or a recording of one. `abilities`: what can be done to it here. `fleet`: its agents are processes,
 * which go on whatever is shown of them. `watching`: another page steers it; `another`: what runs there is not the
 * mission that this page has open.
 */
export interface StartedMessage {
  type: "started";
  run: string;
  tick_ms: number;
  seed: number;
  world: World;
  agents: StartedAgent[];
  stock: Record<string, number>;
  total: number;
  abilities: ("force" | "set" | "seek" | "fail" | "step")[];
  recording: boolean;
  fail_rate: number;
  fleet: boolean;
  watching: boolean;
  another: boolean;
  pens: number[];
}

/** A first program; `places` says for each set of robots that it fits where it can be had. */
export interface Starter {
  name: string;
  label: Record<string, string>;
  help: Record<string, string>;
  places: Record<string, string[]>;
}

/**
 * What became of the run; `sentence` says why it ended, `hits` why it pauses. "end" is that of a recording only.
 * `problems` are hints on a run that ended before anything could be seen.
 */
export interface StateMessage {
  type: "state";
  status: "running" | "paused" | "done" | "failed" | "stuck" | "time" | "stopped" | "end";
  tick: number;
  seconds: number;
  sentence: string;
  hits: Hit[];
  problems: Problem[];
}

/**
 * The state that a walk has come to, the last step to it, and the steps that are possible there. `more` is how many of
 * them are left out at the end.
 */
export interface StateWalk {
  places: number[];
  happened: string[];
  situation: string[];
  shared: string[];
  scene: Scene;
  possible: PossibleStep[];
  more: number;
}

/** Take these steps from the first state of a mission; with `goes_on`, then those to which there is no other. */
export interface StateWalkAsk {
  mission: Mission;
  path: string;
  seed: number;
  timing: Timing;
  failures?: number;
  kinds?: ("fail" | "stall" | "mute")[];
  places: number[];
  goes_on?: boolean;
}

/** Go one tick while paused, or until `agent` stands at another vertex ("" for anybody); `back` into the past. */
export type StepRequest = { type: "step"; by?: "tick" | "vertex"; back?: boolean; agent?: string };

/** End the run. */
export type StopRequest = { type: "stop" };

/** A rectangle (x, y: its lower left corner) with room for `capacity` boxes, `stock` of them there at the start. */
export interface Storehouse {
  name: string;
  x_mm: number;
  y_mm: number;
  width_mm: number;
  height_mm: number;
  capacity: number;
  stock: number;
}

/** What an agent does or what becomes of it in a stretch, and how many seconds after its beginning. */
export interface StretchEvent {
  seconds: number;
  kind: "load" | "unload" | "message" | "collision" | "failure" | "revival" | "member" | "end" | "outside";
  agent: string;
  text: string;
}

/** A study so far; row number n is point n // `seeds`. */
export interface Study {
  study: string;
  axes: StudyAxis[];
  seeds: number;
  measures: string[];
  seconds: number;
  version: string;
  done: number;
  total: number;
  confidence: number;
  points: StudyPoint[];
  command: string;
}

/** What varies, and all its values in their order, each once. */
export type StudyAxis = { address: string; values: (number | string)[] };

/** A measure at a point: of how many runs, and its interval where it has one. */
export interface StudyCell {
  runs: number;
  estimate: number | null;
  low: number | null;
  high: number | null;
  method: string;
}

/** A study that lies beside the mission: the name of its folder, and its runs when it is complete. */
export type StudyEntry = { study: string; runs: number };

/** A point: its number, its values by axis, how many runs had which outcome, its cells by measure. */
export interface StudyPoint {
  number: number;
  values: (number | string)[];
  outcomes: Record<string, number>;
  cells: StudyCell[];
}

/** One run: its number and seed, how it ended, and its measures by place; None: nothing was measured. */
export type StudyRun = { row: number; seed: number; outcome: string; sentence: string; measures: (number | null)[] };

/** A file that was handed in; `modified` is a moment in UTC, `exercise` the one that it is the work for, or "". */
export type Submission = { name: string; bytes: number; modified: string; exercise?: string };

/** One run: who failed, by the place in `agents`, and when, by that in `moments`; how it ended, when and why. */
export interface SweepField {
  agent: number;
  moment: number;
  outcome: "done" | "failed" | "stuck" | "time";
  seconds: number;
  sentence: string;
}

/**
 * What came of a sweep: `moments` in simulated seconds, `fields` as far as they are over, `outcome` and `sentence` of
 * the run without these failures.
 */
export interface SweepMapMessage {
  type: "map";
  agents: string[];
  moments: number[];
  outcome: "done" | "failed" | "stuck" | "time";
  sentence: string;
  total: number;
  fields: SweepField[];
}

/** How many fields are over, of how many. */
export type SweepProgressMessage = { type: "progress"; done: number; total: number };

/**
 * Run this mission once for each agent and moment at which that one fails. Everything else is as in a run's start: the
 * chosen field is the run of the same mission, seed and limit with that failure on its schedule.
 */
export interface SweepStartRequest {
  type: "start";
  mission: Mission;
  path: string;
  seed: number;
  fail_rate?: number;
  moments: number;
  seconds: number;
}

/** The list of a gradebook as it was kept: how many pupils it has, and which of the class it lacks. */
export type TeacherGradebook = { pupils: number; unlisted: string[] };

/** The name it has, and how many got it. */
export type TeacherHandedOut = { name: string; pupils: number };

/** The address that opens an exercise in this class, and its QR code: rows of 0 and 1. */
export type TeacherLink = { address: string; qr: string[] };

/** The last lines of the log, the newest first. */
export type TeacherLog = { lines: string[] };

/**
 * The marks as CSV: the name of the file and its text, how many exercises, and whom the gradebook's list lacks.
 * `listed`: there is such a list.
 */
export type TeacherMarks = { name: string; text: string; exercises: number; listed: boolean; unlisted: string[] };

/** What a teacher wants to know of a tutorial: its aim, how long it takes, what goes wrong, what to ask after it. */
export interface TeacherPage {
  minutes: number;
  aim: Record<string, string>;
  troubles: Record<string, string>[];
  questions: Record<string, string>[];
}

/** One pupil. */
export type TeacherPupil = { folder: string };

/**
 * An agent of the team that programs were sent to, or that was started, last; `address` of its board, "" for none.
 * `message` is what it said last, or (`failed`) what went wrong.
 */
export interface TeamAgent {
  name: string;
  address: string;
  state: "idle" | "sending" | "sent" | "starting" | "there" | "ended";
  progress: BoardProgress | null;
  message: string;
  help: string;
  way: "" | "replace" | "fresh";
  failed: boolean;
}

/** The board of an agent; `way`: what else may be done when its program is sent. */
export type TeamBoard = { agent: string; address: string; way?: "" | "replace" | "fresh" };

/** Break off the sending to a team. */
export type TeamCancelRequest = { type: "team-cancel" };

/** Roles, groups and agents under one name, and what happens when one of them fails. */
export interface TeamGroup {
  name: string;
  above?: string[];
  after?: string | null;
  members: string[];
  failure: "drop" | "substitute" | "abort";
}

/**
 * The team of this studio as it stands; there is one at a time. `path` is the file of its mission. `stopped_ms`: within
 * how many ms all agents said that they stand still, after the emergency stop; null before.
 */
export interface TeamMessage {
  type: "team";
  phase: "idle" | "sending" | "starting" | "running" | "stopping";
  path: string;
  agents: TeamAgent[];
  message: string;
  help: string;
  failed: boolean;
  stopped_ms: number | null;
}

/**
 * A team as it stands: its members, the names of its groups, also of those left empty, and where some wait. A role that
 * robots move from or to is a group of its name.
 */
export type TeamNow = { members: Member[]; groups: string[]; meetings: Meeting[] };

/** A role, the kind of robot that can play it, and how many are wanted. */
export interface TeamRole {
  name: string;
  above?: string[];
  after?: string | null;
  robot: string;
  least: number;
  most: number;
}

/**
 * Put the programs of a team's agents onto their boards, which then wait for the team to be started. When one of them
 * cannot be made, nothing is sent.
 */
export type TeamSendRequest = { type: "team-send"; mission: Mission; path: string; boards: TeamBoard[] };

/** A world to begin with; `world` has its label and help. */
export type Template = { name: string; world: OwnWorld };

/** The canonical text of a `.krt`. */
export type Text = { text: string };

/** Something that can be pushed, around its middle; of a ball width and height are its diameter. */
export type Thing = { kind: "box" | "ball"; x_mm: number; y_mm: number; width_mm: number; height_mm: number };

/**
 * The run as it stands; `agents` holds only those that changed since the last message, and of very many only those that
 * are looked at. `latest` is the furthest tick of this future: less than before when another one has begun. `events`
 * are those since the last message, or with `again` all up to `latest`. `team` is null where it stands as before, or
 * there is none, and so is `drawing`.
 */
export interface TickMessage {
  type: "tick";
  tick: number;
  latest: number;
  again: boolean;
  seconds: number;
  agents: Record<string, AgentReport>;
  stock: Record<string, number>;
  delivered: Record<string, number>;
  collisions: number;
  events: RunEvent[];
  team: TeamNow | null;
  drawing: Drawing | null;
}

/** An assumption about when agents tick. */
export type Timing = "lockstep" | "prompt" | "free";

/** What an example is about. */
export type Topic = { name: string; label: Record<string, string> };

/** The pupil lets the teacher edit; or does not, or not any more. */
export type TurnMessage = { type: "turn"; yes: boolean };

/**
 * A tutorial; `start` is the mission it begins with, `order` its place on the path to learn. One that cannot be used
 * has no steps but `problems`.
 */
export interface Tutorial {
  name: string;
  start: string;
  label: Record<string, string>;
  help: Record<string, string>;
  icon: string;
  order: number;
  steps: TutorialStep[];
  teacher: TeacherPage | null;
  problems: Problem[];
}

/** For each step, whether the programs are as it wants them. */
export type TutorialFit = { fits: boolean[] };

/** One step. `asks`: the program has to be in some way; `events`: one of these has to happen meanwhile. */
export interface TutorialStep {
  label: Record<string, string>;
  help: Record<string, string>;
  hint: Record<string, string>;
  points: Point[];
  asks: boolean;
  events: string[];
}

/** What a variable holds or a parameter takes. */
export type ValueType = "integer" | "boolean";

/**
 * A variable that a person wants for a kind of robot; `was` is the name of the one that it takes the place of.
 * `variables` are those of the mission already; min, max and initial of a truth are not looked at but `initial` != 0.
 */
export interface VariableAsk {
  path: string;
  variables: OwnVariable[];
  robot: string;
  was?: string;
  name: string;
  type: "integer" | "boolean";
  min: number;
  max: number;
  initial: number;
  shared: boolean;
}

/**
 * The answers under one assumption. They come once more when the simulator was searched for what is broken. `odds`: of
 * an approximate check, the odds that a state which a step leads to was missed.
 */
export interface VerifyColumnMessage {
  type: "column";
  timing: Timing;
  failures: number;
  states: number;
  depth: number;
  cut: CutReason | null;
  seconds: number;
  is_approximate: boolean;
  odds: number | null;
  properties: CheckedProperty[];
}

/** The check is over; what is taken for granted in its answers. */
export type VerifyEndMessage = { type: "end"; limits: string[] };

/** How far the check is under one assumption: see `kitrobot.checking.background_check.ExplorationProgress`. */
export interface VerifyProgressMessage {
  type: "progress";
  timing: Timing;
  failures: number;
  states: number;
  depth: number;
  seconds: number;
  memory: number;
}

/**
 * Check this mission, with up to so many failures of these kinds, for so many seconds of the clock on the wall. Or look
 * at many more states approximately.
 */
export interface VerifyStartRequest {
  type: "start";
  mission: Mission;
  path: string;
  seed: number;
  failures?: number;
  kinds?: ("fail" | "stall" | "mute")[];
  seconds: number;
  approximate?: boolean;
}

/**
 * A program element: `element` is Start, Stop, a constructor's name, or `Object.Method`. `settings` holds what was
 * typed into number and text slots, or parameters, by name. `unknown` keeps, word for word, XML inside the vertex that
 * we do not know.
 */
export type Vertex = { id: string; element: string; settings: Record<string, string>; notes: Note[]; unknown?: string };

/**
 * In which order the conditions of a visit come: any; each for the first time in this one; only in this one, over and
 * over.
 */
export type VisitOrder = "any" | "given" | "turn";

/** A straight wall without thickness. */
export type Wall = { x1: number; y1: number; x2: number; y2: number };

/** Watch a run that another page steers; `run` is its name, `mission` what this page has open. */
export type WatchRequest = { type: "watch"; run: string; mission: Mission };

/** Why a property broke: see `kitrobot.checking.run_explanation.RunExplanation`. */
export interface Why {
  sentences: string[];
  certainty: Certainty;
  step: number;
  left_out: number;
  other: OtherWay | null;
  tick: number;
  seconds: number;
  kept: KeptRun | null;
}

/** Units of work, and the seconds after which an unfinished one is free again. */
export type Work = { name: string; above?: string[]; after?: string | null; units: number; lease?: number | null };

/** Why nothing came of it; `problems` are the errors of the mission, where it has some. */
export type WorkRefusedMessage = { type: "refused"; message: string; help: string; problems: Problem[] };

/** The place of a mission. */
export interface World {
  name: string;
  width_mm: number;
  height_mm: number;
  walls: Wall[];
  floors: FloorOutline[];
  lines: LineOutline[];
  roads: Road[];
  docks: DockPose[];
  storehouses: Storehouse[];
  starts: StartPose[];
  things?: Thing[];
  zones?: Zone[];
}

/** A world that a mission can take place in; `href` is what the mission calls it, "" for the empty one. */
export interface WorldEntry {
  href: string;
  shipped: boolean;
  label: Record<string, string>;
  help: Record<string, string>;
  world: World | null;
  problems: Problem[];
}

/** The world of a mission: None when its file is not there, or is no world. */
export type WorldFile = { world: World | null };

/**
 * Where it is warm, loud or bright, around its middle: a circle, or a rectangle where `radius_mm` is 0. Inside it has
 * its value, in °C (warm) or percent; beyond its edge that fades evenly, to nothing at `falloff_mm`.
 */
export interface Zone {
  kind: "warm" | "loud" | "bright";
  x_mm: number;
  y_mm: number;
  radius_mm: number;
  width_mm: number;
  height_mm: number;
  value: number;
  falloff_mm: number;
}

export type RunMessage = StartedMessage | StateMessage | TickMessage | ProblemsMessage | ErrorMessage;

export type RunRequest =
  | StartRequest
  | ReplayRequest
  | RobotsRequest
  | FleetRequest
  | WatchRequest
  | PauseRequest
  | ResumeRequest
  | StepRequest
  | SeekRequest
  | ForceRequest
  | SetRequest
  | HarmRequest
  | LookRequest
  | BreakpointsRequest
  | StopRequest
  | SpeedRequest;
