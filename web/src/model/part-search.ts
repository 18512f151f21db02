/**
 * Finding parts by what a person types: by their names, and by the words that their XML gives them in the reader's language.
 *
 * Accents, capitals and the forms of a letter make no difference. Pure: parts and a query go in, ranks come out.
 */
import { languageInUse } from "../i18n/words";
import { type Parts, partsOf, type Shape, shortTitle, title } from "./parts";
import { robotKinds } from "./robot-kinds";
import { text } from "./texts";
import type { Catalogue } from "./types";

/** How many other robots, and parts of each, are told of. */
const MOST_TOLD = 3;

/** The worst rank of a part that is found by whole beginnings of words. */
const BY_WORDS = 2;

const ARABIC_FORMS: Readonly<Record<string, string>> = { ي: "ی", ى: "ی", ك: "ک", ه: "ہ", ة: "ہ" };

/** A text without what a person may leave out: capitals, accents, the other forms of a letter. */
export function plain(words: string): string {
  return words
    .normalize("NFD")
    .replace(/\p{M}/gu, "")
    .toLowerCase()
    .replace(/[يىكهة]/g, (letter) => ARABIC_FORMS[letter] ?? letter);
}

interface SearchTerms {
  language: string;
  names: string[];
  /** The words of its names. */
  own: string[];
  /** The words that its XML gives it. */
  given: string[];
  all: string;
}

const known = new WeakMap<Shape, SearchTerms>();

function searchTermsOf(shape: Shape): SearchTerms {
  const language = languageInUse();
  const before = known.get(shape);
  if (before?.language === language) return before;
  const names = [title(shape), shortTitle(shape), shape.method?.name ?? "", shape.element].map(plain);
  const own = names.flatMap((name) => name.split(/[\s.'’]+/));
  const spoken = [shape.constructor_?.words, shape.method?.words, shape.object?.words].flatMap((words) => [
    ...(words?.[language] ?? []),
    ...(words?.[""] ?? []),
  ]);
  const given = spoken.map(plain).flatMap((word) => [word, ...word.split(" ")]);
  const object = shape.object === null ? "" : plain(text(shape.object.label, shape.object.name));
  const all = [...names, object, plain(shape.constructor_?.group ?? "")].join(" ");
  const made = { language, names, own: [...own, ...object.split(" ")], given, all };
  known.set(shape, made);
  return made;
}

/** Whether a word begins as it is typed; a plural finds its word too. */
function begins(word: string, typed: string): boolean {
  return word.startsWith(typed) || (word !== "" && typed === `${word}s`);
}

/** How well a part answers what was typed: 0 is best, null is not at all. */
export function rank(shape: Shape, query: string): number | null {
  const wanted = plain(query.trim());
  if (wanted === "") return 0;
  const { names, own, given, all } = searchTermsOf(shape);
  if (names.some((name) => name.startsWith(wanted))) return 0;
  const typed = wanted.split(/\s+/);
  if (typed.every((one) => own.some((word) => begins(word, one)))) return 1;
  if (given.some((word) => begins(word, wanted))) return BY_WORDS;
  if (typed.every((one) => [...own, ...given].some((word) => begins(word, one)))) return BY_WORDS;
  return typed.every((one) => all.includes(one)) ? BY_WORDS + 1 : null;
}

/** Another robot that can do what was typed, by the names of its parts. */
export interface Elsewhere {
  robot: string;
  parts: string[];
}

/** The other robots of the catalogue that have a part for what was typed. */
export function elsewhere(catalogue: Catalogue, { robot }: Parts, query: string): Elsewhere[] {
  if (robot === null || query.trim() === "") return [];
  return robotKinds(catalogue.robots)
    .filter(({ name }) => name !== robot.name)
    .flatMap(({ name, label }): Elsewhere[] => {
      const found = partsOf(catalogue, name).all.flatMap((shape) => {
        const category = shape.object?.category;
        const at = category === "actuator" || category === "sensor" ? rank(shape, query) : null;
        return at === null || at > BY_WORDS ? [] : [{ at, name: title(shape) }];
      });
      const parts = found.sort((a, b) => a.at - b.at).map((one) => one.name);
      return parts.length === 0 ? [] : [{ robot: label, parts: [...new Set(parts)].slice(0, MOST_TOLD) }];
    })
    .slice(0, MOST_TOLD);
}
