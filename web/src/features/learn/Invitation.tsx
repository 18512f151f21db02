/** Under an empty program: where the path to learn goes on, above what else is offered there. */
import { type ReactNode, useEffect } from "react";

import { t } from "../../i18n/words";
import { show } from "../../session/document";
import type { Lesson } from "../../session/lesson";
import { lookForLessons, openLesson, useLessons } from "../../session/lessons";
import { Path } from "./Path";
import "./learn.css";

/** Under an empty program there is room for so many. */
const MOST = 4;

/** The first ones that are not learned; the first ones where all are. */
export function firstOpen(path: readonly Lesson[], learned: readonly string[]): Lesson[] {
  const usable = path.filter((one) => one.usable);
  const open = usable.filter(({ name }) => !learned.includes(name));
  return (open.length > 0 ? open : usable).slice(0, MOST);
}

/**
 * Nothing while a lesson is open. All of it is drawn at once, so that no card moves away from under a pointer.
 */
export function Invitation({ children }: { children: ReactNode }) {
  const { path, learned } = useLessons();
  const open = useLessons((lessons) => openLesson(lessons) !== null);
  useEffect(() => void lookForLessons(), []);
  if (open || path === null) return null;
  const shown = firstOpen(path, learned);
  return (
    <>
      {shown.length === 0 ? null : (
        <section className="learn-invitation" aria-label={t("learn.open")}>
          <div className="row between">
            <h2>{t("learn.invite")}</h2>
            <button type="button" className="text-button muted" data-testid="all-lessons" onClick={() => show("learn")}>
              {t("learn.all")}
            </button>
          </div>
          <Path lessons={shown} brief />
        </section>
      )}
      {children}
    </>
  );
}
