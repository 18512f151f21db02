/** The sheets of the teacher's page: a mission to hand out, an exercise, a new pupil, the log. */
import { type FormEvent, type ReactNode, useState } from "react";

import { classApi } from "../../../api/class";
import { api } from "../../../api/client";
import { exerciseApi } from "../../../api/exercises";
import type { Exercise, MissionEntry } from "../../../api/generated";
import { t } from "../../../i18n/words";
import { text } from "../../../model/texts";
import { Icon } from "../../../theme";
import { Button } from "../../../ui/Button";
import { Field } from "../../../ui/Field";
import { Sheet } from "../../../ui/Sheet";
import { useFetched } from "../../../ui/use-fetched";
import { act, fail, look, say, useDesk } from "./store";

export type SheetName = "send" | "exercise" | "add" | "log";

interface SheetProps {
  onClose: () => void;
  /** Whom it is about; null: all. */
  folders: readonly string[] | null;
}

function useFound<T>(get: () => Promise<T>): T | null {
  return useFetched(get, (cause) => {
    fail(cause);
    return null;
  });
}

function Send({ onClose, folders }: SheetProps) {
  const missions = useFound<MissionEntry[]>(api.missions);
  const pupils = useDesk(({ seen }) => seen);
  const own = missions?.filter(({ path, example }) => !example && !pupils.has(path.split("/")[0] ?? "")) ?? [];
  const examples = missions?.filter(({ example }) => example) ?? [];
  const send = (path: string) => {
    onClose();
    act(classApi.handOut(path, folders).then(({ name, pupils: count }) => say(t("teacher.handed", { name, count }))));
  };
  return (
    <Sheet title={t("teacher.send-title")} testId="sheet-send" onClose={onClose} wide>
      <p className="sheet-note muted small-text">{t("teacher.send-help")}</p>
      <ul>
        {[...own, ...examples].map((one) => (
          <li key={one.path}>
            <button
              type="button"
              className="open-entry row start-text gap-xl hover"
              data-path={one.path}
              onClick={() => send(one.path)}
            >
              <Icon name="file" size={16} />
              <span className="open-title ellipsis medium" dir="auto">
                {text(one.label, one.title || one.name)}
              </span>
              <span className="open-path ellipsis muted small-text slim" dir="auto">
                {one.example ? text(one.help) : one.path}
              </span>
            </button>
          </li>
        ))}
      </ul>
    </Sheet>
  );
}

function isShipped(name: string): boolean {
  return name.startsWith("example:");
}

function ChooseExercise({ onClose }: SheetProps) {
  const all = useFound<Exercise[]>(exerciseApi.all);
  const now = useDesk((desk) => desk.news?.exercise ?? "");
  const choose = (name: string) => {
    onClose();
    act(classApi.setExercise(name));
  };
  const pupils = useDesk(({ seen }) => seen);
  const some = all?.filter(({ goals }) => goals.length > 0) ?? [];
  // Of the folder's own the copy that pupils have is shown only while it is chosen; nothing of a pupil's folder is.
  const own = some.filter(({ name }) => {
    const [top = ""] = name.split("/");
    return name === now ? !isShipped(name) : !isShipped(name) && top !== "Handed out" && !pupils.has(top);
  });
  const usable = [...own, ...some.filter(({ name }) => isShipped(name))];
  return (
    <Sheet title={t("teacher.exercise-title")} testId="sheet-exercise" onClose={onClose} wide>
      <p className="sheet-note muted small-text">{t("teacher.exercise-help")}</p>
      <ul>
        {usable.map(({ name, label, icon, goals }) => (
          <li key={name}>
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

function Add({ onClose }: SheetProps) {
  const [name, setName] = useState("");
  const add = (event: FormEvent) => {
    event.preventDefault();
    if (name.trim() === "") return;
    onClose();
    act(classApi.add(name).then(({ folder }) => look(folder)));
  };
  return (
    <Sheet title={t("teacher.add-title")} testId="sheet-add" onClose={onClose}>
      <form onSubmit={add}>
        <p className="sheet-note muted small-text">{t("teacher.add-help")}</p>
        <Field label={t("teacher.add-name")}>
          <input
            className="field"
            value={name}
            maxLength={60}
            dir="auto"
            autoFocus
            data-testid="add-name"
            onChange={(event) => setName(event.target.value)}
          />
        </Field>
        <div className="sheet-foot flex gap-m justify-end">
          <Button ink type="submit">
            {t("teacher.add")}
          </Button>
        </div>
      </form>
    </Sheet>
  );
}

function Log({ onClose }: SheetProps) {
  const found = useFound(classApi.log);
  return (
    <Sheet title={t("teacher.log-title")} testId="sheet-log" onClose={onClose} wide>
      <ol className="class-log" dir="ltr">
        {found?.lines.map((line, at) => (
          <li key={at} dir="auto">
            {line}
          </li>
        ))}
      </ol>
    </Sheet>
  );
}

export const SHEETS: Record<SheetName, (props: SheetProps) => ReactNode> = {
  send: Send,
  exercise: ChooseExercise,
  add: Add,
  log: Log,
};
