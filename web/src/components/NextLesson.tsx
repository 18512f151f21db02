/** Leads on along the path to learn once the lesson that is open is done; draws nothing before, and after the last one. */
import { useEffect, useRef } from "react";

import { t } from "../i18n/words";
import { text } from "../model/texts";
import { lookForLessons, nextOfOpen, openLesson, useLessons } from "../session/lessons";
import { Icon } from "../theme";
import { Button } from "../ui/Button";

interface NextLessonProps {
  testId: string;
  /** Enter goes on; who types somewhere goes on typing. */
  takesFocus?: boolean;
}

export function NextLesson({ testId, takesFocus = false }: NextLessonProps) {
  const done = useLessons((lessons) => openLesson(lessons)?.done === true);
  const next = useLessons(nextOfOpen);
  const button = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (done) void lookForLessons();
  }, [done]);
  useEffect(() => {
    const types = document.activeElement?.matches("input, textarea, [contenteditable='true']") === true;
    if (takesFocus && next !== null && !types) button.current?.focus();
  }, [takesFocus, next]);
  if (next === null) return null;
  return (
    <Button ink ref={button} className="row" testId={testId} onClick={next.begin}>
      {t("learn.next", { name: text(next.label) })}
      <Icon name="arrow-right" size={16} />
    </Button>
  );
}
