/** What the cards of robots and the lines of a team are made of: buttons, how far a sending is, what went wrong. */
import { type ReactNode, useId } from "react";

import type { Failure } from "../../api/refusal";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import type { Board } from "./wire";

interface ActProps {
  icon: string;
  label: string;
  testId: string;
  onPress: () => void;
  ink?: boolean;
  disabled?: boolean;
  title?: string;
}

export function Act({ icon, label, testId, onPress, ...rest }: ActProps) {
  return (
    <Button icon={icon} iconSize={14} testId={testId} onClick={onPress} {...rest}>
      {label}
    </Button>
  );
}

/** How far the sending of a program is; with what can be done about it. */
export function Sending({
  progress,
  testId,
  children,
}: {
  progress: Board["progress"];
  testId: string;
  children?: ReactNode;
}) {
  const label = useId();
  const { step, done, total } = progress ?? { step: "connect" as const, done: 0, total: 0 };
  return (
    <div className="robot-progress small-text" data-testid={testId}>
      <span id={label}>{t(`boards.step-${step}`)}</span>
      <progress aria-labelledby={label} value={total > 0 ? done : undefined} max={Math.max(total, 1)} />
      {children}
    </div>
  );
}

/** What went wrong, in the server's words; with what can be done about it. */
export function TroubleBox({ said, testId, children }: { said: Failure; testId: string; children?: ReactNode }) {
  return (
    <div className="robot-trouble notice flex below items-start" role="alert" data-testid={testId}>
      <Icon name="triangle-alert" size={16} />
      <p className="grow">
        <strong>
          <Said text={said.message} />
        </strong>{" "}
        <Said text={said.help} />
        {children}
      </p>
    </div>
  );
}

type Way = Exclude<Board["way"], "">;

/** The way in which a program can be sent all the same, where there is one. */
export function WayOut({ way, of, onPress }: { way: Board["way"]; of: string; onPress: (way: Way) => void }) {
  if (way === "") return null;
  return (
    <button
      type="button"
      className="robot-link start-text medium"
      data-testid={`${of}-${way}`}
      onClick={() => onPress(way)}
    >
      {t(`boards.${way}`)}
    </button>
  );
}
