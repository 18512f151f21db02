/** Why the server did not do some work: the sentence, the first errors of the mission, and the way to all of them. */
import "./refused.css";

import type { WhyRefused } from "../api/refusal";
import { Said } from "../i18n/Said";
import { t } from "../i18n/words";
import { openDock } from "../session/dock";
import { PROBLEMS } from "../session/problem-walk";
import { Button } from "../ui/Button";

const SHOWN_PROBLEMS = 3;

export function Refusal({ refused }: { refused: WhyRefused | null }) {
  if (refused === null) return null;
  const errors = refused.problems.filter(({ severity }) => severity === "error");
  return (
    <div className="refused prose" role="alert" data-testid="refused">
      <p>
        <Said text={refused.message} /> <Said text={refused.help} />
      </p>
      {errors.length === 0 ? null : (
        <>
          <ul>
            {errors.slice(0, SHOWN_PROBLEMS).map((problem, index) => (
              <li key={index}>
                <Said text={problem.message} />
              </li>
            ))}
          </ul>
          <Button onClick={() => openDock(PROBLEMS)}>{t("work.problems")}</Button>
        </>
      )}
    </div>
  );
}
