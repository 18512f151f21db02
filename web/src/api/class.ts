/**
 * Requests to the class that this page belongs to: a server of its own, whichever Python answers what the page asks of its
 * mission. A pupil's key, or the teacher's, comes along (`token.ts`).
 */
import { t } from "../i18n/words";
import type { Mission } from "../model/types";
import { socketAddress } from "./address";
import { ApiError, type RequestOptions, refusal, request } from "./client";
import type * as server from "./generated";
import { type Silence, watchSilence } from "./silence";

/** What marks are written for. */
export const GRADEBOOKS = ["moodle", "canvas", "sheet"] as const;
export type Gradebook = (typeof GRADEBOOKS)[number];

const unreached = () => new ApiError(t("class.offline"), t("class.offline-help"));

async function answer(path: string, asked: RequestOptions = {}): Promise<Response> {
  const response = await request(`class${path}`, asked, (address, options) => fetch(address, options), unreached);
  if (!response.ok) throw await refusal(response);
  return response;
}

async function ask<T>(path: string, asked: RequestOptions = {}): Promise<T> {
  return (await (await answer(path, asked)).json()) as T;
}

async function bytes(path: string): Promise<{ bytes: ArrayBuffer; revision: string }> {
  const response = await answer(path);
  return { bytes: await response.arrayBuffer(), revision: (response.headers.get("etag") ?? "").replaceAll('"', "") };
}

const post = (json: unknown): RequestOptions => ({ method: "POST", json });
const chosen = (folders: readonly string[] | null) =>
  folders === null ? "" : `?${folders.map((one) => `folder=${encodeURIComponent(one)}`).join("&")}`;

export const classApi = {
  about: () => ask<server.Class>(""),
  join: (code: string, name: string, word: string) => ask<server.Joined>("/join", post({ code, name, word })),
  ask: (code: string, name: string) => ask<server.AdmissionRequest>("/ask", post({ code, name })),
  asked: (asked: string) => ask<server.ClassAnswered>("/asked", post({ asked })),

  handIn: (name: string, base: string, mission: Mission, exercise: string) =>
    ask<server.HandIn>("/work", { method: "PUT", json: { name, base, mission, exercise } }),
  works: () => ask<server.Submission[]>("/work"),
  work: (name: string) => bytes(`/work/file?name=${encodeURIComponent(name)}`),
  handed: () => bytes("/handed"),
  /** The files of an exercise that was handed out as a ZIP file; empty where it comes with KitRobot. */
  exercise: async (name: string) => (await bytes(`/exercise?name=${encodeURIComponent(name)}`)).bytes,

  picture: async (folder: string): Promise<server.ClassPicture | null> => {
    const found = await answer(`/teacher/picture?folder=${encodeURIComponent(folder)}`);
    return found.status === 204 ? null : ((await found.json()) as server.ClassPicture);
  },
  setCode: (on: boolean) => ask<boolean>("/teacher/code", post({ on })),
  freeze: (on: boolean, folders: readonly string[] | null) => ask<boolean>("/teacher/freeze", post({ on, folders })),
  setExercise: (exercise: string) => ask<boolean>("/teacher/exercise", post({ exercise })),
  link: (exercise: string) => ask<server.TeacherLink>("/teacher/link", post({ exercise })),
  handOut: (path: string, to: readonly string[] | null) =>
    ask<server.TeacherHandedOut>("/teacher/hand-out", post({ path, to })),
  write: (folder: string, text: string) => ask<boolean>("/teacher/note", post({ folder, text })),
  comment: (folder: string, exercise: string, text: string) =>
    ask<boolean>("/teacher/comment", post({ folder, exercise, text })),
  handDown: (folder: string) => ask<boolean>("/teacher/hand-down", post({ folder })),
  turn: (folder: string, asks: boolean) => ask<boolean>("/teacher/turn", post({ folder, ask: asks })),
  add: (name: string) => ask<server.TeacherPupil>("/teacher/add", post({ name })),
  remove: (folder: string) => ask<boolean>("/teacher/remove", post({ folder })),
  removeIdle: () => ask<number>("/teacher/remove-idle", { method: "POST" }),
  setPlaces: (places: number) => ask<number>("/teacher/places", post({ places })),
  answer: (asked: string, yes: boolean) => ask<boolean>("/teacher/answer", post({ asked, yes })),
  log: () => ask<server.TeacherLog>("/teacher/log"),
  collect: (folders: readonly string[] | null) => bytes(`/teacher/collect${chosen(folders)}`),
  table: () => bytes("/teacher/table"),
  grade: (folders: readonly string[] | null) => ask<number>("/teacher/grade", post({ folders })),
  marks: (gradebook: Gradebook) => ask<server.TeacherMarks>(`/teacher/marks?gradebook=${gradebook}`),
  keepGradebook: (list: ArrayBuffer) =>
    ask<server.TeacherGradebook>("/teacher/gradebook", { method: "PUT", bytes: list }),
  grades: () => bytes("/teacher/grades"),
};

const AGAIN_MS = 2000;

export interface ClassSocket<Said> {
  say: (said: Said) => void;
  close: () => void;
}

interface Hears<Heard> {
  onMessage: (message: Heard) => void;
  onOpen: () => void;
  onLost: () => void;
  /** The connection is open, and the class does not answer; or it does again. */
  onSilence: (silent: boolean) => void;
}

/** A socket that is sought again until it is closed here. */
export function openClassSocket<Said, Heard extends { type: string }>(
  path: string,
  hears: Hears<Heard>,
): ClassSocket<Said> {
  let socket: WebSocket | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let over = false;
  let listening: Silence | undefined;
  const open = () => {
    socket = new WebSocket(socketAddress(`api/class/${path}`));
    const opened = socket;
    const silence = watchSilence(() => opened.readyState === WebSocket.OPEN && opened.send("?"), hears.onSilence);
    listening = silence;
    socket.addEventListener("open", () => {
      if (!over) hears.onOpen();
    });
    socket.addEventListener("message", ({ data }: MessageEvent<string>) => {
      silence.heard();
      const message = JSON.parse(data) as Heard | server.HereMessage;
      if (!over && message.type !== "here") hears.onMessage(message as Heard);
    });
    socket.addEventListener("close", () => {
      silence.end();
      if (over) return;
      timer = setTimeout(open, AGAIN_MS);
      hears.onLost();
    });
  };
  open();
  return {
    say: (said) => {
      if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(said));
    },
    close: () => {
      over = true;
      clearTimeout(timer);
      listening?.end();
      socket?.close();
    },
  };
}
