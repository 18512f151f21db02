/** Why a property broke, in three sentences at most, and what can be played from the moment that decided it. */
import type { CheckedProperty, ConfirmingRun } from "../../api/generated";
import { clock } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { isHeldByRobots } from "../../session/confirming-run";
import { useRun } from "../../session/run";
import { Button } from "../../ui/Button";
import { play } from "./check-session";

interface Props {
  answer: CheckedProperty;
  /** Opens the other way. */
  onOther: () => void;
}

export function WhyBroken({ answer, onOther }: Props) {
  const { why, confirmed } = answer;
  if (why === null) return null;
  const { sentences, left_out: leftOut, other, kept } = why;
  return (
    <section className="check-why column gap-s" data-testid="check-why" aria-label={t("check.why")}>
      <h4>{t("check.why")}</h4>
      <ol>
        {sentences.map((sentence, index) => (
          <li key={index}>
            <Said text={sentence} />
          </li>
        ))}
      </ol>
      <p className="check-play row wrap lesson-head">
        {confirmed !== null && why.tick >= 0 ? (
          <PlayFrom testId="check-play-moment" run={{ ...confirmed, tick: why.tick, seconds: why.seconds }}>
            {t("check.play-moment", { time: clock(why.seconds) })}
          </PlayFrom>
        ) : null}
        {kept === null ? null : (
          <PlayFrom testId="check-play-kept" run={kept}>
            {t(kept.delayed === "" ? "check.play-kept" : "check.play-waits")}
          </PlayFrom>
        )}
        {other === null || other.scenes.length < 2 ? null : (
          <Button icon="git-fork" testId="check-other" aria-haspopup="dialog" onClick={onOther}>
            {t("check.other-way")}
          </Button>
        )}
      </p>
      {leftOut === 0 ? null : <p className="muted small-text">{t("check.not-needed", { count: leftOut })}</p>}
    </section>
  );
}

/** Plays a run of the simulator up to the moment that decided, where it pauses. */
function PlayFrom({ run, testId, children }: { run: ConfirmingRun; testId: string; children: string }) {
  const held = useRun(isHeldByRobots);
  return (
    <Button icon="play" testId={testId} disabled={held} onClick={() => play(run)}>
      {children}
    </Button>
  );
}
