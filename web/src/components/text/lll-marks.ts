/**
 * Which words of an LLL text have which colour: a construct's marks in its category, its closers like its openers.
 *
 * One pass with a stack of open brackets; it never fails, a text with mistakes is coloured as far as it can be read. The
 * meaning of the text is the server's; this only paints.
 */
import type { Category } from "../../theme";

export type MarkClass = Category | "number" | "comment" | "quiet";

export interface Mark {
  from: number;
  to: number;
  look: MarkClass;
}

interface Open {
  close: string;
  look: MarkClass;
  /** What a "(" right after the closer belongs to: the body of a loop, a choice, an event. */
  then: MarkClass | null;
  condition: boolean;
}

const TOKEN = /#[^\n]*|\p{Nd}+|[\p{L}_][\p{L}\p{N}_]*|\/\/|[^\s]/gu;
const IDENT = /^[\p{L}_]/u;
const MARKS = /^[°º˚]$/;

export function lllMarks(text: string): Mark[] {
  const marks: Mark[] = [];
  const stack: Open[] = [];
  /** The colour that the next "(" takes, when a construct has announced its body. */
  let body: MarkClass | null = null;
  let starred = false;
  let number: Mark | null = null;
  let call = false;
  let afterBody = false;

  const add = (from: number, to: number, look: MarkClass): Mark => {
    const mark = { from, to, look };
    marks.push(mark);
    return mark;
  };
  const inCondition = () => stack.at(-1)?.condition ?? false;

  for (const match of text.matchAll(TOKEN)) {
    const word = match[0];
    const from = match.index;
    const to = from + word.length;
    if (word.startsWith("#")) {
      add(from, to, "comment");
      continue;
    }
    const wasStarred = starred;
    const wasNumber = number;
    const wasBody = afterBody;
    starred = false;
    number = null;
    afterBody = false;

    if (/^\p{Nd}/u.test(word)) {
      number = add(from, to, "number");
    } else if (IDENT.test(word)) {
      if (word === "WAIT") {
        add(from, to, "choice");
        body = "choice";
      } else if (word === "BREAK") {
        add(from, to, "loop");
      } else {
        add(from, to, inCondition() ? "test" : "action");
        call = true;
        continue;
      }
    } else if (MARKS.test(word)) {
      add(from, to, "parallel");
    } else if (word === "*") {
      add(from, to, "loop");
      if (wasNumber !== null) wasNumber.look = "loop";
      starred = true;
      body = wasNumber === null ? null : "loop";
    } else if (word === "[" || word === "<") {
      const look = word === "[" && wasStarred ? "loop" : "choice";
      add(from, to, look);
      stack.push({ close: word === "[" ? "]" : ">", look, then: look, condition: true });
    } else if (word === "//") {
      add(from, to, "parallel");
      body = "parallel";
    } else if (word === "!" && wasBody && !inCondition()) {
      add(from, to, "choice");
      body = "choice";
    } else if (word === "(") {
      const look: MarkClass = wasStarred ? "loop" : (body ?? (inCondition() ? "test" : "action"));
      add(from, to, look);
      stack.push({
        close: ")",
        look,
        then: null,
        condition: body === null && (call || inCondition()) && inCondition(),
      });
      body = null;
    } else if (word === ")" || word === "]" || word === ">") {
      const open = stack.at(-1)?.close === word ? stack.pop() : undefined;
      add(from, to, open?.look ?? "quiet");
      body = open?.then ?? null;
      afterBody = word === ")" && open?.look === "choice";
    } else if (word === ",") {
      add(from, to, stack.at(-1)?.look === "parallel" ? "parallel" : "quiet");
    } else if (word === "&" || word === "|" || word === "!") {
      add(from, to, "test");
    } else if (word === "." && call) {
      add(from, to, inCondition() ? "test" : "action");
      continue;
    } else {
      add(from, to, "quiet");
    }
    call = false;
  }
  return marks;
}
