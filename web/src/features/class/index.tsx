/**
 * A class: the page of a pupil, who joins first, and the page of the teacher in place of the studio.
 *
 * A server of a class says in the page's head whom the page is for. Without that word nothing of this is fetched.
 */
import type { ReactNode } from "react";

import { isJoining, pageRole } from "../../api/token";
import { reportError } from "../../session/document";
import type { Feature } from "../../session/features";
import { later } from "../../ui/later";

/** `wanted`: where the page is for that. */
function part(wanted: string, load: () => Promise<() => ReactNode>) {
  return pageRole === wanted ? later(load, reportError) : null;
}

const Teacher = part("teacher", () => import("./teacher/Teacher").then((chunk) => chunk.Teacher));
const Bar = part("pupil", () => import("./Pupil").then((chunk) => chunk.PupilBar));
const Kept = part("pupil", () => import("./Pupil").then((chunk) => chunk.PupilKept));
const Join = part("pupil", () => import("./Join").then((chunk) => chunk.Join));

export const classroom: Feature = {
  name: "class",
  Instead: Teacher ?? (isJoining() ? Join : null),
  ...(Bar !== null && Kept !== null ? { slots: { banner: Bar, bottom: Kept } } : {}),
};
