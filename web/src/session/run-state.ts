/** What the page knows of a run, and what can be asked of it. */
import type { FleetRequest, RobotsRequest, StartRequest, TeamNow } from "../api/generated";
import type { Failure } from "../api/refusal";
import type { Ability, AgentReport, Harm, Hit, RunEvent, StartedAgent } from "../api/wire";
import type { Breakpoint, Mission, Problem, World } from "../model/types";

export type RunStatus =
  "idle" | "connecting" | "running" | "paused" | "done" | "failed" | "stuck" | "time" | "stopped" | "end";

export interface RunAgent extends StartedAgent, AgentReport {}

/** What the page has chosen for any run that goes on by itself. */
type Chosen = "speed" | "breakpoints";

export interface RunState {
  status: RunStatus;
  tick: number;
  /** The furthest tick of this future: further than `tick` when the run stands in its past. */
  latest: number;
  /** Why it pauses; empty when it was asked to. */
  hits: Hit[];
  seconds: number;
  tickMs: number;
  sentence: string;
  agents: RunAgent[];
  world: World | null;
  stock: Record<string, number>;
  delivered: Record<string, number>;
  total: number;
  collisions: number;
  events: RunEvent[];
  /** The team whose program runs, as it stands: who is in which role, and who waits for whom; null without one. */
  team: TeamNow | null;
  seed: number;
  /** The probability (0…1) that a robot fails by chance within a minute, of this run and the next one. */
  failRate: number;
  /** The mission that runs; null without a run. Later edits do not reach it. */
  mission: Mission | null;
  /** How many times real time; 0 is as fast as it goes. */
  speed: number;
  /** program → name of the agent that is watched; the first one of that program where nothing is chosen. */
  selectedAgent: Record<string, string>;
  error: Failure | null;
  /** Why a run could not start, or ended before anything could be seen, as the server says it. */
  problems: Problem[];
  /** The server's name for it; empty without a run. */
  name: string;
  /** What can be done to it here. */
  abilities: readonly Ability[];
  /** Whether it is a recording. */
  recording: boolean;
  /** Whether real robots run: they go on at their own pace, whatever is shown of them. */
  real: boolean;
  /** Whether a team of processes runs: it goes on at its own pace, too. */
  isFleet: boolean;
  /** Whether another page steers it. */
  watching: boolean;
  /** While watching: whether what runs there is not the mission that is open here. */
  another: boolean;
  /** Runs the mission; `like` is what the run has otherwise than is chosen here, its failures among that. */
  start: (what: { mission: Mission; path: string }, like?: Partial<StartRequest>) => void;
  /** Plays a recording that was opened, of this mission. */
  replay: (what: { mission: Mission; recording: string; breakpoints: Breakpoint[] }) => void;
  /**
   * Watches and steers real robots that this page, by its name among those with robots, holds; or runs the mission as a team
   * of processes.
   */
  robots: (what: Omit<RobotsRequest, Chosen | "type"> | Omit<FleetRequest, Chosen>) => void;
  /** Watches a run of this mission that another page steers. */
  watch: (what: { mission: Mission; run: string }) => void;
  pause: () => void;
  resume: () => void;
  /** Goes on from the latest tick: with real robots that is now. */
  follow: () => void;
  stop: () => void;
  /** One tick, or until the agent (anybody where it is empty) stands at another vertex; back pauses the run. */
  step: (by?: "tick" | "vertex", back?: boolean, agent?: string) => void;
  /** Goes to a tick that was run already, and pauses there. */
  seek: (tick: number) => void;
  /** Puts a value in the place of what a sensor measures; null gives it back. */
  force: (agent: string, sensor: string, value: number | null) => void;
  setVariable: (agent: string, variable: string, value: number) => void;
  /** Lets a robot fail, stall or lose its radio, or makes it well again. */
  injectFault: (agent: string, kind: Harm) => void;
  /** These are the breakpoints of the run from now on. */
  pauseAt: (breakpoints: Breakpoint[]) => void;
  setSpeed: (speed: number) => void;
  /** Watches that agent in its program's tab; before a run its program has to be said. */
  selectAgent: (name: string, program?: string) => void;
  /** Forgets the run: the arena shows the mission's own world again. */
  reset: () => void;
  dismissError: () => void;
}
