/**
 * What the page knows of a mission and of the parts it is drawn from: the shapes that the server sends and takes, and names
 * for parts of them. The shapes themselves are generated from the server's models (`api/generated.ts`, types only).
 *
 * Plain data. Nothing is ever changed in place: an edit makes new objects for what it touches and keeps the rest, so
 * that `===` tells what changed.
 */
import type { Constructor, Floor, Slot } from "../api/generated";

export type {
  Agent,
  Arc,
  Breakpoint,
  Catalogue,
  Choice,
  Constructor,
  Corner,
  Fix,
  Fragment,
  Goal,
  Group,
  Meaning,
  Method,
  Mission,
  MissionFile,
  Note,
  OwnVariable,
  OwnWorld,
  Parameter,
  Problem,
  Program,
  ProgramReport,
  ProjectionReport as Projection,
  Report,
  Robot,
  RobotObject,
  AskedProperty,
  Breakdown,
  Radio,
  TeamRole as Role,
  Failure as ScheduledFailure,
  Slot,
  SpanEntry,
  TeamGroup,
  Vertex,
  Work,
  World,
  WorldEntry,
} from "../api/generated";

/** Language tag → text; the empty tag is the default (English). */
export type Texts = Constructor["label"];

export type Colour = Constructor["colour"];
export type SlotKind = Slot["kind"];
export type FloorColour = Floor["colour"];
