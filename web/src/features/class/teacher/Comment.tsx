/** What the teacher writes on a pupil's exercise: it stays, beside the exercise on the pupil's page and in the marks. */
import { type FormEvent, useState } from "react";

import { classApi } from "../../../api/class";
import type { Mark } from "../../../api/generated";
import { t } from "../../../i18n/words";
import { Button } from "../../../ui/Button";
import { act, say } from "./store";

interface CommentProps {
  folder: string;
  name: string;
  exercise: string;
  mark: Mark | null;
}

export function Comment({ folder, name, exercise, mark }: CommentProps) {
  const kept = mark?.comment ?? "";
  const [words, setWords] = useState(kept);
  const keep = (event: FormEvent) => {
    event.preventDefault();
    const gone = words.trim() === "";
    act(
      classApi
        .comment(folder, exercise, words)
        .then(() => say(gone ? t("teacher.comment-gone") : t("teacher.comment-kept", { name }))),
    );
  };
  return (
    <form className="class-write class-comment rigid flex gap-m wrap" onSubmit={keep}>
      {mark?.points == null ? null : (
        <p className="class-muted muted small-text" data-testid="look-mark">
          {t("teacher.mark", { points: mark.points, of: mark.of })}
          {mark.points === 0 ? <>. {t("teacher.mark-none")}</> : null}
        </p>
      )}
      <input
        className="field"
        data-testid="comment"
        value={words}
        maxLength={500}
        dir="auto"
        placeholder={t("teacher.comment", { name })}
        aria-label={t("teacher.comment", { name })}
        onChange={(event) => setWords(event.target.value)}
      />
      <Button icon="check" type="submit" disabled={words.trim() === kept}>
        {t("teacher.comment-keep")}
      </Button>
    </form>
  );
}
