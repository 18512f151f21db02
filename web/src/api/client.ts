/**
 * The server's routes as functions.
 *
 * Each resolves to what the server sent or rejects with an `ApiError`, whose message is a sentence and whose help says what
 * to do; 409 keeps the revision that is on disk. Addresses are relative, so the page works under any path.
 */
import { type Language, languageInUse, t } from "../i18n/words";
import type { Arc, Fragment, Mission, MissionFile, Problem, Report, SpanEntry, Vertex } from "../model/types";
import type * as server from "./generated";
import { renewToken } from "./reconnect";
import { token } from "./token";
import { transport } from "./transport";

/** What became of a typed text: its program, or null and why not; places count in the text that was sent. */
export interface Followed extends server.Followed {
  spans: SpanEntry[];
  problems: Problem[];
}

/** Whether a mission declares of its team what a text declares. */
function declares({ roles = [], groups = [], works = [] }: Mission, declared: server.Declared): boolean {
  return JSON.stringify({ roles, groups, works }) === JSON.stringify(declared);
}

export class ApiError extends Error {
  readonly help: string;
  readonly status: number;
  /** What is on disk, when that is why saving was refused. */
  readonly revision: string;
  /** What is wrong with the file that was refused. */
  readonly problems: readonly Problem[];

  constructor(message: string, help = "", status = 0, revision = "", problems: readonly Problem[] = []) {
    super(message);
    this.name = "ApiError";
    this.help = help;
    this.status = status;
    this.revision = revision;
    this.problems = problems;
  }
}

export interface RequestOptions {
  /** In which the answer is wanted; else in that of the page. */
  language?: Language;
  method?: "GET" | "POST" | "PUT";
  json?: unknown;
  bytes?: ArrayBuffer;
  signal?: AbortSignal;
}

/** What a server says about a request that it refuses; where it says nothing, what `unsaid` makes of the status. */
export async function refusal(
  response: Response,
  unsaid: (status: number) => ApiError | null = () => null,
): Promise<ApiError> {
  let said: { message?: unknown; help?: unknown; revision?: unknown; problems?: Problem[] } = {};
  try {
    said = (await response.json()) as typeof said;
  } catch {
    // Not our server's words: the status is all there is to say.
  }
  const text = (value: unknown) => (typeof value === "string" ? value : "");
  const known = text(said.message) === "" || response.status === 401 ? unsaid(response.status) : null;
  if (known !== null) return known;
  const message = text(said.message) || t("error.unexpected", { status: response.status });
  return new ApiError(message, text(said.help), response.status, text(said.revision), said.problems ?? []);
}

/** The studio does not know this page's token. */
function unknownToken(status: number): ApiError | null {
  return status === 401 || status === REFUSED ? new ApiError(t("error.token"), t("error.token-help"), status) : null;
}

/** One request; the answer is what the caller says it is. */
export async function ask<T>(address: string, asked: RequestOptions = {}): Promise<T> {
  return (await (await answer(address, asked)).json()) as T;
}

/** One request, whose answer is bytes. */
export async function askBytes(address: string): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await (await answer(address, {})).arrayBuffer());
}

const REFUSED = 403;

/** One request; where it is refused because the studio started anew, once more with the token of that. */
async function answer(address: string, asked: RequestOptions): Promise<Response> {
  const mine = token();
  const response = await request(address, asked);
  if (response.ok) return response;
  const failure = refusal(response, unknownToken);
  if (response.status !== REFUSED) throw await failure;
  await renewToken();
  // Another request may have got the new token meanwhile.
  if (token() === mine) throw await failure;
  const again = await request(address, asked);
  if (!again.ok) throw await refusal(again, unknownToken);
  return again;
}

const offline = () => new ApiError(t("error.offline"), t("error.offline-help"));

/** Sends a request: to the studio, or `through` the network to another server, about which `unreached` speaks. */
export async function request(
  address: string,
  { language = languageInUse(), method = "GET", json, bytes, signal }: RequestOptions,
  through: (address: string, asked: RequestInit) => Promise<Response> = transport().fetch,
  unreached = offline,
): Promise<Response> {
  const headers: Record<string, string> = { "Accept-Language": language };
  if (token() !== "") headers["X-KitRobot-Token"] = token();
  if (json !== undefined) headers["Content-Type"] = "application/json";
  if (bytes !== undefined) headers["Content-Type"] = "application/octet-stream";
  try {
    return await through(`api/${address}`, {
      method,
      headers,
      body: json === undefined ? (bytes ?? null) : JSON.stringify(json),
      signal: signal ?? null,
    });
  } catch (cause) {
    if (cause instanceof DOMException && cause.name === "AbortError") throw cause;
    throw unreached();
  }
}

/** The problems of a report that have a place in the LLL of a program. */
export function problemsIn(report: Report | null, program: string): Problem[] {
  const file = `${program}.lll`;
  return report?.problems.filter((one) => one.program === program && one.file === file && one.line > 0) ?? [];
}

/** `after` with the very things of `before` where both say the same; `before` itself where all of them do. */
function reused<T>(before: T[], after: T[], value: (one: T) => unknown): T[] {
  const known = new Map(before.map((one) => [JSON.stringify(value(one)), one]));
  const found = after.map((one) => known.get(JSON.stringify(value(one))) ?? one);
  return found.length === before.length && found.every((one, at) => one === before[at]) ? before : found;
}

const vertexValue = (one: Vertex) => [one.id, one.element, one.settings, one.notes, one.unknown ?? ""];
const arcValue = (one: Arc) => [one.source, one.out, one.target, one.at];

async function follow(mission: Mission, path: string, program: string, text: string): Promise<Followed> {
  const told = await ask<server.Followed>("text", { method: "POST", json: { mission, path, program, text } });
  const spans = told.spans ?? told.report?.programs.find((one) => one.name === program)?.spans ?? [];
  const answer = { ...told, spans, problems: told.problems ?? problemsIn(told.report, program) };
  const before = mission.programs.find((one) => one.name === program);
  if (answer.program === null || before === undefined) return { ...answer, program: null };
  // What did not change stays the same object: by that the page knows what to draw anew.
  const vertices = reused(before.vertices, answer.program.vertices, vertexValue);
  const arcs = reused(before.arcs, answer.program.arcs, arcValue);
  // A text with other declarations is another program, be its graph the same.
  const same = answer.declared == null || declares(mission, answer.declared);
  const unchanged = same && vertices === before.vertices && arcs === before.arcs;
  return { ...answer, program: unchanged ? before : { ...before, vertices, arcs } };
}

export const api = {
  session: () => ask<server.Session>("session"),
  missions: () => ask<server.MissionEntry[]>("missions"),
  mission: (path: string) => ask<MissionFile>(`mission?path=${encodeURIComponent(path)}`),
  newMission: () => ask<MissionFile>("mission/new"),
  readMission: (name: string, bytes: ArrayBuffer) =>
    ask<MissionFile>(`mission/read?name=${encodeURIComponent(name)}`, { method: "POST", bytes }),
  saveMission: (path: string, revision: string, mission: Mission) =>
    ask<server.Saved>("mission", { method: "PUT", json: { path, revision, mission } }),
  missionText: (mission: Mission) => ask<{ text: string }>("mission/text", { method: "POST", json: { mission } }),
  /** A program as a file for a board's drive. */
  boardFile: (wanted: Omit<server.BoardFileAsk, "mission"> & { mission: Mission }) =>
    ask<server.BoardFile>("board-file", { method: "POST", json: wanted }),
  image: (mission: Mission, path: string, program: string) =>
    ask<server.Image>("image", { method: "POST", json: { mission, path, program } }),
  tree: async (mission: Mission, path: string, program: string) =>
    (await ask<server.Text>("tree", { method: "POST", json: { mission, path, program } })).text,
  /** A program of LLL or of a behaviour tree. `own` is what the mission brings along: the text may speak of it. */
  fragment: (text: string, robot: string, path: string, own: Pick<Mission, "constructors" | "variables"> = {}) =>
    ask<Fragment>("fragment", {
      method: "POST",
      json: { text, robot, path, constructors: own.constructors ?? [], variables: own.variables ?? [] },
    }),
  follow,
  check: (mission: Mission, path: string, signal?: AbortSignal) =>
    ask<Report>("check", { method: "POST", json: { mission, path }, ...(signal && { signal }) }),
};
