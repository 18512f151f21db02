/**
 * What a person types into the code panel, and the graph that follows it.
 *
 * A draft is a program's text while it is not (or not laid out as) what the server prints. Each change asks the server for
 * the graph of it and the report of the mission with it, one question at a time and newest-wins; a text without mistakes
 * becomes one command, and commands of one burst join, told by when the letters were typed, not by when the server answered.
 * A text with mistakes leaves the graph alone. A draft goes with the program object it was typed over: when that is replaced
 * by another edit the draft ends, and when undo brings a program back whose text was typed, so does its text.
 */
import { create } from "zustand";

import type { Followed } from "../api/client";
import { failureWords } from "../api/refusal";
import { t } from "../i18n/words";
import { replaceProgram } from "../model/command";
import { useStudio } from "../model/studio";
import type { Mission, Problem, Program, SpanEntry } from "../model/types";
import { changeChecked } from "./report";

export interface Draft {
  text: string;
  /** When it was typed, in ms since 1970. */
  at_ms: number;
  /** The program of the document that goes with this draft; its graph shows the last text without mistakes. */
  program: Program;
  /** Whether the program is what the text says; while it is asked for, what the text before it was. */
  right: boolean;
  /** Whether the server has not answered for this text yet. */
  waiting: boolean;
  spans: SpanEntry[];
  problems: Problem[];
  /** Why the server could not look at the text; "" when it could. */
  failure: string;
}

interface Typing {
  drafts: Record<string, Draft>;
}

export const useTyping = create<Typing>(() => ({ drafts: {} }));

export type Ask = (mission: Mission, path: string, program: string, text: string) => Promise<Followed>;

const typed = new WeakMap<Program, { text: string; spans: SpanEntry[]; at_ms: number }>();
/** Programs whose text the server has not seen yet. */
const wanted = new Set<string>();
let asking = false;
let focused = false;
let ask: Ask = () => Promise.reject(new Error("not connected"));

function programNow(name: string): Program | undefined {
  return useStudio.getState().mission.programs.find((one) => one.name === name);
}

function put(name: string, draft: Draft | null): void {
  useTyping.setState(({ drafts }) => {
    const { [name]: _, ...others } = drafts;
    return { drafts: draft === null ? others : { ...others, [name]: draft } };
  });
}

/** The text of a program was typed to be `text`; `before` is the text before. */
export function typeText(name: string, text: string, before: { text: string; spans: SpanEntry[] }): void {
  const program = programNow(name);
  if (program === undefined) return;
  const draft = useTyping.getState().drafts[name];
  const at_ms = Date.now();
  if (draft === undefined) typed.set(program, { ...before, at_ms });
  const old = draft ?? { right: true, problems: [] };
  put(name, { ...old, text, at_ms, program, waiting: true, spans: [], failure: "" });
  wanted.add(name);
  // Before the letter is on the screen: the server works while the page draws it.
  void next();
}

async function next(): Promise<void> {
  while (!asking) {
    const [name] = wanted;
    if (name === undefined) return;
    wanted.delete(name);
    asking = true;
    await follow(name);
    asking = false;
  }
}

async function follow(name: string): Promise<void> {
  const draft = useTyping.getState().drafts[name];
  if (draft === undefined) return;
  const { mission, file } = useStudio.getState();
  try {
    take(name, draft, await ask(mission, file.path, name, draft.text), mission);
  } catch (cause) {
    const failure = failureWords(cause);
    const now = useTyping.getState().drafts[name];
    if (now?.text === draft.text) put(name, { ...now, right: false, waiting: false, problems: [], failure });
  }
}

function take(name: string, asked: Draft, followed: Followed, mission: Mission): void {
  const now = useTyping.getState().drafts[name];
  if (now === undefined || now.text !== asked.text || now.program !== asked.program) return;
  const answered = { ...now, waiting: false, spans: followed.spans, problems: followed.problems, failure: "" };
  const { program } = followed;
  if (program === null) {
    put(name, { ...answered, right: false });
    return;
  }
  const { text, at_ms } = asked;
  typed.set(program, { text, spans: followed.spans, at_ms });
  put(name, { ...answered, program, right: true });
  if (program === asked.program) return;
  const { mission: before, execute } = useStudio.getState();
  const { label, execute: replaced } = replaceProgram(t("code.edit-text"), asked.program, program);
  const all = (one: Mission) => ({ ...replaced(one), ...followed.declared });
  const command = { label, execute: all, joins: `text ${name}`, at_ms };
  if (before !== mission || followed.report === null) execute(command);
  else changeChecked(followed.report, () => execute(command));
}

/** The editor was entered or left. Left with a text that is right, it shows the one true layout again. */
export function setFocused(name: string, on: boolean): void {
  focused = on;
  if (on) return;
  const draft = useTyping.getState().drafts[name];
  if (draft?.right === true && !draft.waiting) put(name, null);
}

/** Whether the text has been changed since the last one that the graph shows. */
export function isUnfinished(name: string): boolean {
  const draft = useTyping.getState().drafts[name];
  return draft !== undefined && (draft.waiting || !draft.right);
}

/** Does something with the program as it is typed: at once, or when the server has answered for the last letter. */
export function whenFollowed(go: () => void): void {
  const waits = () => Object.values(useTyping.getState().drafts).some(({ waiting }) => waiting);
  if (!waits()) {
    go();
    return;
  }
  const off = useTyping.subscribe(() => {
    if (waits()) return;
    off();
    // The answer is in the document by the end of this turn.
    queueMicrotask(go);
  });
}

/** Follows the document: drafts end when their program is edited elsewhere. The returned function stops that. */
export function connectTyping(asking: Ask): () => void {
  ask = asking;
  const off = useStudio.subscribe((state, before) => {
    if (state.mission === before.mission) return;
    for (const [name, draft] of Object.entries(useTyping.getState().drafts)) {
      const program = state.mission.programs.find((one) => one.name === name);
      if (program === draft.program) continue;
      wanted.delete(name);
      const known = program === undefined || !focused ? undefined : typed.get(program);
      if (program === undefined || known === undefined) put(name, null);
      else put(name, { ...known, program, right: true, waiting: false, problems: [], failure: "" });
    }
  });
  const offTyping = useTyping.subscribe(({ drafts }) => {
    // Left while the server was still asked: the answer ends the draft.
    if (focused) return;
    for (const [name, draft] of Object.entries(drafts)) if (draft.right && !draft.waiting) put(name, null);
  });
  return () => {
    off();
    offTyping();
    wanted.clear();
    useTyping.setState({ drafts: {} });
  };
}
