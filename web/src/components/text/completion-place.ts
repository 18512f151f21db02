/**
 * What may stand at a place of an LLL text, told by the brackets that are open before it and by the words of a team's forms
 * and declarations. A word of a team is a name where a dot follows it, as for the reader of the language.
 */

/**
 * What may stand at a place. Of a team's text also: names of a set ("members"), of a program, of a group or role
 * ("group"), of a kind of robot ("robot"), what goes on behind the members or the units of a declaration ("on", "lease"),
 * and a rule for failures ("failure"). "none": nothing that could be offered, as in a comment, for a new name or number.
 */
export type Standing =
  | "instruction"
  | "condition"
  | "parameter"
  | "members"
  | "program"
  | "group"
  | "robot"
  | "on"
  | "failure"
  | "lease"
  | "none";

export interface Place {
  standing: Standing;
  /** Where the name begins that is being typed; the end of the text where none is. */
  from: number;
  /** Whether a declaration may stand there. */
  declares: boolean;
  /** Roles and groups that are declared before, as they are written. */
  declared: string[];
  /** The role or group in whose declaration it is, as it is written; "" where it is in none. */
  within: string;
}

interface Level {
  closer: string;
  standing: "instruction" | "condition" | "parameter" | "members";
  /** The tokens of the instruction, or of the test, that is being written; a bracket in it is its last sign. */
  head: string[];
}

const NAME = String.raw`[\p{L}_][\p{L}\p{M}\p{N}_]*(?:-[\p{L}\p{M}\p{N}_]+)*`;
const TOKEN = new RegExp(String.raw`#[^\n]*|"(?:[^"]|"")*"?|${NAME}(?:-(?!>))?|->|\.\.|\/\/|\p{N}+|[^\s]`, "gu");
const WORD = /^[\p{L}_]/u;
const NAMING = /^["\p{L}_]/u;

const CLOSERS: Readonly<Record<string, string>> = { "[": "]", "<": ">", "{": "}", "(": ")" };
const BLOCKS = ["SeqOfPar", "ParOfSeq", "Where"];
const QUANTIFIERS = ["any", "all", "most"];
const DECLARATIONS = ["role", "group", "work"];

/** What may stand behind the first tokens of a declaration. */
function inDeclaration(head: readonly string[]): Standing {
  const [word, , , fourth] = head;
  if (word === "role") return head.length === 3 ? "robot" : "none";
  if (word === "work") return fourth !== undefined && head.length === 4 ? "lease" : "none";
  // group NAME = set on failure RULE
  return (["none", "none", "none", "members", "on", "none", "failure"] as const)[head.length] ?? "none";
}

/** What may stand behind the tokens of an instruction or test that is being written. */
function behind({ standing, head }: Level, outermost: boolean): Standing {
  const [word, second] = head;
  if (word === undefined || second === "." || second === "(") return standing;
  if (standing === "instruction") {
    if (outermost && DECLARATIONS.includes(word)) return inDeclaration(head);
    if (word === "PROGRAM") return "program";
    if (word === "MOVE") return head.length === 2 || head.length === 4 ? "group" : "none";
    if (BLOCKS.includes(word)) return head.length === 1 ? "members" : "none";
  }
  if (standing === "condition" && QUANTIFIERS.includes(word)) return head.length === 1 ? "members" : "none";
  return standing;
}

/** What is meant by a bracket that opens behind the tokens of an instruction or test. */
function inside({ standing, head }: Level, team: boolean): Level["standing"] {
  const [word = "", second] = head;
  const last = head.at(-1) ?? "";
  if (second !== "." && (team || head.length > 1)) {
    if (standing === "instruction" && BLOCKS.includes(word)) return "instruction";
    if (standing === "condition" && QUANTIFIERS.includes(word)) return "condition";
  }
  return WORD.test(last) ? "parameter" : standing;
}

/** The role or group that the tokens of a declaration declare; "" where they declare none. */
function declaredBy([word, name = "", sign]: readonly string[]): string {
  return (word === "role" && sign === ":") || (word === "group" && sign === "=") ? name : "";
}

/** Whether an instruction is over with its newest token, whatever follows. */
function isOver([word, second, ...more]: readonly string[]): boolean {
  if (second === ".") return false;
  return (word === "PROGRAM" && second !== undefined) || (word === "MOVE" && more.length === 3);
}

/** What may stand at the end of that text; `team`: it is the text of a team's program. */
export function placeAtEnd(before: string, team = false): Place {
  const outermost: Level = { closer: "", standing: "instruction", head: [] };
  const open: Level[] = [];
  const declared: string[] = [];
  let declares = true;
  let from = before.length;
  for (const match of before.matchAll(TOKEN)) {
    const token = match[0];
    const isLast = match.index + token.length === before.length;
    if (token.startsWith("#")) {
      if (isLast) return { standing: "none", from, declares: false, declared, within: "" };
      continue;
    }
    // A name is open until it is closed, or until something stands behind it.
    if (NAMING.test(token) && isLast && (!token.startsWith('"') || (token.match(/"/gu) ?? []).length % 2 === 1)) {
      from = match.index;
      break;
    }
    const around = open.at(-1) ?? outermost;
    if (around === outermost && around.head.length === 0 && token !== ";")
      declares = declares && DECLARATIONS.includes(token);
    const opened = { "[": "condition", "<": "condition", "{": "members", "(": inside(around, team) }[token];
    if (opened !== undefined)
      open.push({ closer: CLOSERS[token] ?? "", standing: opened as Level["standing"], head: [] });
    else if (around.closer === token) {
      open.pop();
      const outside = open.at(-1) ?? outermost;
      // A call, a body and a joint test are over with their bracket; a set and a guard are parts of what goes on.
      outside.head = token === ")" ? [] : [...outside.head, token];
    } else if (";,&|!°".includes(token)) {
      const name = around === outermost ? declaredBy(around.head) : "";
      if (name !== "") declared.push(name);
      around.head = [];
    } else {
      around.head.push(token);
      if (around === outermost && token === "." && around.head.length === 2) declares = false;
      if (isOver(around.head)) around.head = [];
    }
  }
  const level = open.at(-1) ?? outermost;
  declares = declares && level === outermost && level.head.length === 0;
  const within = declaredBy(outermost.head);
  return { standing: behind(level, level === outermost), from, declares, declared, within };
}
