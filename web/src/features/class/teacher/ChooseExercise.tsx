/** The sheet of exercises: that of the class, and a link to each. */
import { useState } from "react";

import { classApi } from "../../../api/class";
import { exerciseApi } from "../../../api/exercises";
import type { Exercise, TeacherLink } from "../../../api/generated";
import { whyRefused } from "../../../api/refusal";
import { CopyButton } from "../../../components/CopyButton";
import { Said } from "../../../i18n/Said";
import { t } from "../../../i18n/words";
import { text } from "../../../model/texts";
import { Icon } from "../../../theme";
import { Button } from "../../../ui/Button";
import { copyText } from "../../../ui/copy-text";
import { Sheet } from "../../../ui/Sheet";
import { Qr } from "./Qr";
import { act, useDesk, useFound } from "./store";

function isShipped(name: string): boolean {
  return name.startsWith("example:");
}

/** A link that was asked for: it is on the clipboard, or stands there to be copied; or why there is none. */
interface Linked {
  exercise: string;
  words: string;
  link: TeacherLink | null;
}

async function linkTo(exercise: string, name: string): Promise<Linked> {
  try {
    const link = await classApi.link(exercise);
    const copied = await copyText(link.address);
    return { exercise, words: t(copied ? "teacher.link-copied" : "teacher.link-shown", { name }), link };
  } catch (cause) {
    const { message, help } = whyRefused(cause);
    return { exercise, words: `${message} ${help}`.trim(), link: null };
  }
}

/** Below its exercise, so that nothing moves under the pointer. */
function LinkCard({ words, link }: Linked) {
  return (
    <div className="class-link surface row wrap gap-2xl slim" data-testid="exercise-link">
      {link === null ? null : <Qr rows={link.qr} label={t("teacher.link-qr")} />}
      <div className="class-link-words column slim gap-s">
        <p aria-hidden="true">
          <Said text={words} />
        </p>
        {link === null ? null : (
          <span className="row slim gap-s">
            <code className="breakable small-text slim" dir="ltr">
              {link.address}
            </code>
            <CopyButton
              text={link.address}
              label={t("teacher.copy-link")}
              copied={t("code.copied")}
              testId="copy-again"
            />
          </span>
        )}
      </div>
    </div>
  );
}

export function ChooseExercise({ onClose }: { onClose: () => void }) {
  const all = useFound<Exercise[]>(exerciseApi.all);
  const now = useDesk((desk) => desk.news?.exercise ?? "");
  const pupils = useDesk(({ seen }) => seen);
  const [linked, setLinked] = useState<Linked | null>(null);
  const choose = (name: string) => {
    onClose();
    act(classApi.setExercise(name));
  };
  const some = all?.filter(({ goals }) => goals.length > 0) ?? [];
  // Of the folder's own the copy that pupils have is shown only while it is chosen; nothing of a pupil's folder is.
  const own = some.filter(({ name }) => {
    const [top = ""] = name.split("/");
    return name === now ? !isShipped(name) : !isShipped(name) && top !== "Handed out" && !pupils.has(top);
  });
  const usable = [...own, ...some.filter(({ name }) => isShipped(name))];
  return (
    <Sheet title={t("teacher.exercise-title")} testId="sheet-exercise" onClose={onClose} wide>
      <p className="sheet-note muted small-text">
        {t("teacher.exercise-help")} {t("teacher.link-help")}
      </p>
      <p className="only-spoken" role="status" data-testid="exercise-link-said">
        {linked?.words}
      </p>
      <ul>
        {usable.map(({ name, label, icon, goals }) => (
          <li key={name} className="row wrap slim gap-s">
            <button
              type="button"
              className="class-entry open-entry row start-text gap-xl hover slim"
              aria-pressed={name === now}
              data-path={name}
              onClick={() => choose(name)}
            >
              <Icon name={icon} size={18} />
              <span className="open-title ellipsis medium">{text(label)}</span>
              <span className="open-path ellipsis muted small-text slim" dir="auto">
                {[t("exercise.count", { count: goals.length }), ...(isShipped(name) ? [] : [name])].join(" · ")}
              </span>
              {name === now ? <Icon name="check" size={16} /> : null}
            </button>
            <Button
              icon={linked?.exercise === name && linked.link !== null ? "check" : "copy"}
              className="small rigid"
              aria-label={t("teacher.copy-link-to", { name: text(label) })}
              data-link={name}
              onClick={() => void linkTo(name, text(label)).then(setLinked)}
            >
              {t("teacher.copy-link")}
            </Button>
            {linked?.exercise === name ? <LinkCard {...linked} /> : null}
          </li>
        ))}
        <li>
          <button type="button" className="open-entry row start-text gap-xl hover" onClick={() => choose("")}>
            <Icon name="circle-slash-2" size={18} />
            <span className="open-title ellipsis medium">{t("teacher.no-exercise-more")}</span>
          </button>
        </li>
      </ul>
    </Sheet>
  );
}
