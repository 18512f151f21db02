/**
 * Where a step points: what of the page a point means, in words, as a CSS selector for the ring, and how to get there.
 *
 * A ring follows by itself: a rule of style sits on whatever the selector finds, now and after the page was drawn anew.
 */
import type { Point } from "../../api/generated";
import { type Key, t } from "../../i18n/words";
import { type Parts, shortTitle, title } from "../../model/parts";
import { text } from "../../model/texts";
import type { Program, Texts } from "../../model/types";
import { reveal as revealVertex } from "../../session/actions";
import { type Panel, useLayout } from "../../session/layout";
import { openRoom } from "../../session/narrow";
import { reveal } from "../../session/reveal";
import { setBeside } from "../../session/stage";
import { useView } from "../../session/view";
import { hasCoarsePointer } from "../../i18n/touch";
import { whenThere } from "../../ui/when-there";

const BUTTONS: Readonly<Record<string, { testid: string; words: Key }>> = {
  run: { testid: "run-button", words: "tutorial.point-run" },
  pause: { testid: "pause-button", words: "run.pause" },
  step: { testid: "step-button", words: "run.step" },
  stop: { testid: "stop-button", words: "run.stop" },
  speed: { testid: "speed", words: "tutorial.point-speed" },
  undo: { testid: "undo", words: "edit.undo" },
  redo: { testid: "redo", words: "edit.redo" },
  "add-program": { testid: "add-program", words: "tabs.add" },
  problems: { testid: "problems", words: "problems.title" },
  "team-tab": { testid: "tab-of-team", words: "team.tab" },
  "team-side": { testid: "side-team", words: "roster.team" },
  "parts-side": { testid: "side-parts", words: "roster.parts" },
  members: { testid: "members-button", words: "members.title" },
  projection: { testid: "code-tab-projection", words: "code.projection" },
  "file-menu": { testid: "menu-File", words: "tutorial.point-file-menu" },
};

const PANELS: Readonly<Record<string, { selector: string; words: Key }>> = {
  palette: { selector: ".parts", words: "view.palette" },
  canvas: { selector: "#canvas-panel", words: "app.canvas" },
  inspector: { selector: '[data-testid="inspector"]', words: "view.inspector" },
  code: { selector: '[data-testid="code"]', words: "view.code" },
  arena: { selector: '[data-testid="arena"]', words: "view.arena" },
  roster: { selector: '[data-testid="roster"]', words: "roster.label" },
  spare: { selector: '[data-testid="card-spare"]', words: "roster.spare" },
  members: { selector: '[data-testid="members"]', words: "members.title" },
};

/** What a point is about: the program in view and its parts. */
export interface Page {
  program: Program | undefined;
  parts: Parts;
}

function byTestid(id: string): string {
  return `[data-testid="${CSS.escape(id)}"]`;
}

/** The vertices of the program in view that a point means, in their order. */
function vertices({ name }: Point, { program }: Page): string[] {
  return program?.vertices.filter((vertex) => vertex.element === name).map((vertex) => vertex.id) ?? [];
}

/** In the place of something of the team that is not shown, the tab that shows it. */
function ofTeam(selector: string): string {
  return `${selector}, body:not(:has(${selector})) ${byTestid("side-team")}`;
}

/** What the ring goes around; "" where there is nothing of the kind. */
export function selectorOf(point: Point, page: Page): string {
  switch (point.kind) {
    case "part":
      return byTestid(`part-${point.name}`);
    case "vertex": {
      const [first] = vertices(point, page);
      if (first === undefined) return "";
      if (point.inner === "") return byTestid(`vertex-${first}`);
      return [
        byTestid(`slot-${first}.${point.inner}`),
        `.field-number:has(${byTestid(`field-${first}.${point.inner}`)})`,
        `body:not(:has(${byTestid(`field-${first}.${point.inner}`)})):not(:has(${byTestid(`slot-${first}.${point.inner}`)})) ${byTestid(`vertex-${first}`)}`,
      ].join(", ");
    }
    case "button": {
      const button = BUTTONS[point.name];
      return button === undefined ? "" : byTestid(button.testid);
    }
    case "panel":
      if (point.name === "spare" || point.name === "roster") return ofTeam(PANELS[point.name]?.selector ?? "");
      return PANELS[point.name]?.selector ?? "";
    case "group":
      return ofTeam(
        point.inner === ""
          ? byTestid(`card-${point.name}`)
          : `label:has(${byTestid(`failure-${point.name}-${point.inner}`)})`,
      );
    case "program":
      return byTestid(`tab-${point.name}`);
  }
}

function partName(element: string, { parts }: Page): string {
  const shape = parts.all.find((one) => one.element === element);
  if (shape === undefined) return element;
  return title(shape);
}

/** What a text says in braces, as the page names it: {Wheel}, {Wheel.Advance}, {Wheel.Advance speed}; null for none. */
function nameIn(braces: string, { parts }: Page): string | null {
  const shape = parts.all.find((one) => one.element === braces);
  if (shape !== undefined) return shortTitle(shape);
  const object = parts.all.find((one) => one.object?.name === braces)?.object;
  if (object != null) return text(object.label, object.name);
  const space = braces.lastIndexOf(" ");
  const owner = parts.all.find((one) => one.element === braces.slice(0, space));
  const name = braces.slice(space + 1);
  const inner = [...(owner?.fields ?? []), ...(owner?.plugs ?? []), ...(owner?.flows ?? [])];
  const found = inner.find((one) => one.name === name);
  return found === undefined ? null : text(found.label, name);
}

/** {two|words}, also where a name in them is not known. */
const EITHER = /\{((?:[^{}|]|\{[^{}|]*\})*)\|((?:[^{}|]|\{[^{}|]*\})*)\}/g;

/**
 * A text of a tutorial, with the names of parts as the reader sees them in the palette. Of {two|words} the first is for a
 * mouse and a keyboard, the second for fingers; either may have names in it.
 */
export function told(texts: Texts, page: Page): string {
  const named = text(texts).replace(/\{([^{}]+)\}/g, (whole, braces: string) => nameIn(braces, page) ?? whole);
  const fingers = hasCoarsePointer();
  return named.replace(EITHER, (_, mouse: string, finger: string) => (fingers ? finger : mouse));
}

/** A point in words: "Wheel Advance in the parts". */
export function wordsOf(point: Point, page: Page): string {
  switch (point.kind) {
    case "part":
      return t("tutorial.point-part", { name: partName(point.name, page) });
    case "vertex":
      return t("tutorial.point-vertex", { name: partName(point.name, page) });
    case "button":
      return t(BUTTONS[point.name]?.words ?? "tutorial.title");
    case "panel":
      return t(PANELS[point.name]?.words ?? "tutorial.title");
    case "program":
      return t("tutorial.point-program", { name: point.name });
    case "group":
      return t("tutorial.point-group", { name: point.name });
  }
}

function focus(selector: string): void {
  const found = selector === "" ? null : document.querySelector<HTMLElement>(selector);
  if (found === null) return;
  const inner = found.matches("button, input, a[href], [tabindex]")
    ? found
    : found.querySelector<HTMLElement>("button:not(:disabled), input, [tabindex]");
  found.scrollIntoView({ block: "nearest", inline: "nearest" });
  (inner ?? found).focus({ preventScroll: true });
}

/** The panel of the page in which a point is; null for the graph and what stands around it. */
function panelOf({ kind, name, inner }: Point): Panel | null {
  if (kind === "part" || kind === "group" || name === "roster" || name === "spare") return "palette";
  if (kind === "vertex") return inner === "" ? null : "inspector";
  return kind === "panel" && (name === "palette" || name === "inspector" || name === "code" || name === "arena")
    ? name
    : null;
}

/** Opens the panel, wherever it was folded away: on a phone it is the room under the graph. */
function openPanel(panel: Panel | null): void {
  const { folded, toggle } = useLayout.getState();
  if (panel !== null && folded[panel]) toggle(panel);
  if (panel === "inspector" || panel === "code") setBeside(false);
  openRoom(panel);
}

/** Brings what a point means into view and gives it the focus. */
export function goToPoint(point: Point, page: Page): void {
  openPanel(panelOf(point));
  if (point.kind === "part") {
    // A palette that was folded away is drawn first.
    requestAnimationFrame(() => reveal(point.name));
    return;
  }
  if (point.kind !== "vertex") {
    requestAnimationFrame(() => focus(selectorOf(point, page)));
    return;
  }
  const [first] = vertices(point, page);
  if (first === undefined || page.program === undefined) return;
  revealVertex(page.program.name, [first]);
  useView.getState().viewport?.focus();
  if (point.inner === "") return;
  // The inspector shows the vertex once it is selected.
  requestAnimationFrame(() => {
    const field = byTestid(`field-${first}.${point.inner}`);
    whenThere(field, () => {
      focus(field);
    });
  });
}
