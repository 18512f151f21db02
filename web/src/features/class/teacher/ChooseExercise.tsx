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
  words: string;
  link: TeacherLink | null;
}

async function linkTo(exercise: string, name: string): Promise<Linked> {
  try {
    const link = await classApi.link(exercise);
    const copied = await copyText(link.address);
    return { words: t(copied ? "teacher.link-copied" : "teacher.link-shown", { name }), link };
  } catch (cause) {
    const { message, help } = whyRefused(cause);
    return { words: `${message} ${help}`.trim(), link: null };
  }
}

/** What came of the last press of Copy link. */
function LinkNote({ linked }: { linked: Linked | null }) {
  return (
    <div className="class-link" role="status" data-testid="exercise-link">
      {linked === null ? null : (
        <div className="surface row gap-xl slim">
          {linked.link === null ? null : <Qr rows={linked.link.qr} label={t("teacher.link-qr")} />}
          <div className="column slim">
            <p>
              <Said text={linked.words} />
            </p>
            {linked.link === null ? null : (
              <span className="row slim gap-s">
                <code className="breakable small-text slim" dir="ltr">
                  {linked.link.address}
                </code>
                <CopyButton
                  text={linked.link.address}
                  label={t("teacher.copy-link")}
                  copied={t("code.copied")}
                  testId="copy-again"
                />
              </span>
            )}
          </div>
        </div>
      )}
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
      <LinkNote linked={linked} />
      <ul>
        {usable.map(({ name, label, icon, goals }) => (
          <li key={name} className="row slim gap-s">
            <button
              type="button"
              className="open-entry row start-text gap-xl hover"
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
              icon="copy"
              className="small rigid"
              aria-label={t("teacher.copy-link-to", { name: text(label) })}
              data-link={name}
              onClick={() => void linkTo(name, text(label)).then(setLinked)}
            >
              {t("teacher.copy-link")}
            </Button>
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
