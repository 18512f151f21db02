/** What the cards of roles, groups and work have in common. */
import { type ComponentProps, type ReactNode, useState } from "react";

import { NumberInput } from "../../../components/fields/NumberInput";
import { NameCell } from "../../../components/NameCell";
import { Said } from "../../../i18n/Said";
import { sentence, t } from "../../../i18n/words";
import { declaredNames, removeDeclared, renameDeclared } from "../../../model/commands/changeDeclared";
import { firstFree } from "../../../model/free-name";
import { execute, useStudio } from "../../../model/studio";
import type { Problem } from "../../../model/types";
import { Icon } from "../../../theme";
import { Tool } from "../../../ui/Tool";
import { useOver } from "./Chip";
import type { Goal } from "./roster-moves";

/** Why nothing declared can have that name, or "". */
export function wrongName(name: string, work = false): string {
  if (name === "") return t("roster.name-empty");
  if (work && !/^[\p{L}_][\p{L}\p{M}\p{N}_]*$/u.test(name)) return t("roster.name-work");
  return declaredNames(useStudio.getState().mission).includes(name) ? t("roster.name-taken", { name }) : "";
}

/** The largest count of anything declared. */
export const MOST = 65_535;

/** A name like the given one that nothing declared has. */
export function freeDeclared(name: string): string {
  const { mission } = useStudio.getState();
  const taken = new Set([...declaredNames(mission), ...mission.agents.map((one) => one.name)]);
  return firstFree(
    (number) => (number === 1 ? name : `${name}${String(number)}`),
    (one) => taken.has(one),
  );
}

function isAbout({ code, message }: Problem, name: string): boolean {
  return code.startsWith("team-") && message.includes(`\`${name}\``);
}

/** What the check says of a declaration. */
function Trouble({ name }: { name: string }) {
  const found = useStudio((studio) => studio.report?.problems.find((one) => one.program === "" && isAbout(one, name)));
  const elsewhere = useStudio((studio) => studio.report?.problems.find((one) => isAbout(one, name)));
  const one = found ?? elsewhere;
  if (one === undefined) return null;
  return (
    <p className="roster-card-trouble small-text flex gap-s items-start" role="status" data-testid={`trouble-${name}`}>
      <Icon name={one.severity === "error" ? "octagon-x" : "triangle-alert"} size={14} />{" "}
      <span>
        <Said text={sentence(one.message)} />
      </span>
    </p>
  );
}

interface CardProps {
  name: string;
  /** What stands beside the name. */
  note: string;
  icon: string;
  work?: boolean;
  goal?: Goal;
  /** What can be changed, shown when the pencil was pressed. */
  fields: ReactNode;
  children: ReactNode;
}

/** A declaration: its name, what can be changed of it, and what is in it. A place to drop where it has a `goal`. */
export function Card({ name, note, icon, work = false, goal, fields, children }: CardProps) {
  const [open, setOpen] = useState(false);
  const { over, why } = useOver(goal ?? { kind: "spare", name: `no ${name}` });
  const place = goal === undefined ? {} : { "data-goal": goal.kind, "data-name": goal.name };
  return (
    <li
      className="roster-card surface column"
      data-testid={`card-${name}`}
      data-over={over ? (why === "" ? "takes" : "refuses") : undefined}
      {...place}
    >
      <div className="roster-card-head row gap-s">
        <Icon name={icon} size={16} />
        <strong dir="auto" title={name}>
          {name}
        </strong>
        <small>{note}</small>
        <Tool
          small
          icon="pencil"
          iconSize={14}
          label={t("roster.change", { name })}
          testId={`change-${name}`}
          aria-expanded={open}
          onClick={() => setOpen(!open)}
        />
      </div>
      {open ? (
        <div className="roster-card-fields column gap-s">
          <div className="roster-card-name gap-xs">
            <NameCell
              name={name}
              label={t("roster.name", { name })}
              testId={`name-${name}`}
              wrong={(wanted) => wrongName(wanted, work)}
              keep={(to) => {
                const { mission, catalogue } = useStudio.getState();
                execute(renameDeclared(mission, catalogue, name, to));
              }}
            />
            <Tool
              small
              icon="trash-2"
              label={t("roster.remove", { name })}
              testId={`remove-${name}`}
              onClick={() => execute(removeDeclared(useStudio.getState().mission, name))}
            />
          </div>
          {fields}
        </div>
      ) : null}
      {children}
      {over && why !== "" ? (
        <p className="roster-card-why small-text" role="status" data-testid="drop-why">
          {why}
        </p>
      ) : null}
      <Trouble name={name} />
    </li>
  );
}

/** A whole number of a declaration. */
export function Count({ label, title, ...number }: ComponentProps<typeof NumberInput> & { title?: string }) {
  return (
    <label className="column muted tiny-text gap-2xs" title={title}>
      {label}
      <NumberInput {...number} whole />
    </label>
  );
}
