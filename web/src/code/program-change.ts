/** Two programs as one: what is equal stays the same object, so that `===` goes on telling what changed. */
import type { Arc, Note, Program, Vertex } from "../model/types";

function sameSettings(a: Record<string, string>, b: Record<string, string>): boolean {
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => a[name] === b[name]);
}

function sameNotes(a: readonly Note[], b: readonly Note[]): boolean {
  return a.length === b.length && a.every((note, at) => note.text === b[at]?.text && note.at === b[at].at);
}

function sameVertex(a: Vertex, b: Vertex): boolean {
  return a.element === b.element && sameSettings(a.settings, b.settings) && sameNotes(a.notes, b.notes);
}

function arcName(arc: Arc): string {
  return JSON.stringify([arc.source, arc.out, arc.target, arc.at]);
}

/** `after` with the vertices and arcs of `before` that did not change; `before` itself when nothing did. */
export function sharing(before: Program, after: Program): Program {
  const known = new Map(before.vertices.map((vertex) => [vertex.id, vertex]));
  const drawn = new Map(before.arcs.map((arc) => [arcName(arc), arc]));
  const vertices = after.vertices.map((vertex) => {
    const was = known.get(vertex.id);
    return was !== undefined && sameVertex(was, vertex) ? was : vertex;
  });
  const arcs = after.arcs.map((arc) => drawn.get(arcName(arc)) ?? arc);
  const same =
    vertices.length === before.vertices.length &&
    arcs.length === before.arcs.length &&
    vertices.every((vertex, at) => vertex === before.vertices[at]) &&
    arcs.every((arc, at) => arc === before.arcs[at]);
  return same ? before : { ...before, vertices, arcs };
}
