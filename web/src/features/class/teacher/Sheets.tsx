/** The sheets of the teacher's page: a mission to hand out, a new pupil, the log; and their names. */
import { type FormEvent, type ReactNode, useState } from "react";

import { classApi } from "../../../api/class";
import { api } from "../../../api/client";
import type { MissionEntry } from "../../../api/generated";
import { t } from "../../../i18n/words";
import { text } from "../../../model/texts";
import { Icon } from "../../../theme";
import { Button } from "../../../ui/Button";
import { Field } from "../../../ui/Field";
import { Sheet } from "../../../ui/Sheet";
import { ChooseExercise } from "./ChooseExercise";
import { act, look, say, useDesk, useFound } from "./store";

export type SheetName = "send" | "exercise" | "add" | "log";

interface SheetProps {
  onClose: () => void;
  /** Whom it is about; null: all. */
  folders: readonly string[] | null;
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
