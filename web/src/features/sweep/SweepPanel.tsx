/** The panel of the sweep: what is asked, how far it is, and the map. */
import { useState } from "react";

import { DockPanel } from "../../components/DockPanel";
import { Refusal } from "../../components/Refusal";
import { grouped, readNumber, readWhole } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { Button } from "../../ui/Button";
import { Row } from "../../ui/Row";
import { Select } from "../../ui/Select";
import { SweepMap } from "./SweepMap";
import { begin, breakOff, useSweep } from "./sweep-session";
import "./sweep.css";

const MOMENTS = ["10", "25", "50", "100", "200"];
const LONGEST_S = 36_000;
const PAIRS = "kitrobot run … --fail-sweep --pairs";

export function SweepPanel() {
  const swept = useSweep((sweep) => sweep.swept);
  const refused = useSweep((sweep) => sweep.refused);
  return (
    <DockPanel id="sweep-panel" testId="sweep" title={t("sweep.title")} close={t("sweep.close")}>
      <div className="dock-body column gap-m">
        <Asking />
        <Refusal refused={refused} />
        {swept === null ? null : <SweepMap swept={swept} />}
      </div>
    </DockPanel>
  );
}

/** What is asked for; while the sweep is on, how far it is. */
function Asking() {
  const agents = useStudio((studio) => studio.mission.agents.length);
  const busy = useSweep((sweep) => sweep.busy);
  const swept = useSweep((sweep) => sweep.swept);
  const [moments, setMoments] = useState(() => String(swept?.map.moments.length ?? 25));
  const [typed, setTyped] = useState(() => String(swept?.asked.seconds ?? 600));
  const seconds = readNumber(typed) ?? 0;
  const wrong = !(seconds > 0 && seconds <= LONGEST_S);
  if (agents === 0 && swept === null) return <p className="prose muted">{t("sweep.nobody")}</p>;
  if (busy !== null) return <Progress {...busy} />;
  return (
    <>
      {swept === null ? (
        <p className="prose muted">
          {t("sweep.what")} <Said text={t("sweep.pairs", { command: `\`${PAIRS}\`` })} />
        </p>
      ) : null}
      <form
        className="sweep-asking row wrap"
        onSubmit={(event) => {
          event.preventDefault();
          if (!wrong) begin(readWhole(moments) ?? 0, seconds);
        }}
      >
        <Row label={t("sweep.moments")}>
          <Select
            label={t("sweep.moments")}
            testId="sweep-moments"
            value={moments}
            options={MOMENTS.includes(moments) ? MOMENTS : [moments, ...MOMENTS]}
            keep={setMoments}
          />
        </Row>
        <Row label={t("sweep.seconds")}>
          <input
            className="field"
            type="text"
            inputMode="decimal"
            maxLength={8}
            data-testid="sweep-seconds"
            aria-invalid={wrong}
            aria-describedby={wrong ? "sweep-seconds-wrong" : undefined}
            value={typed}
            onChange={(event) => setTyped(event.target.value)}
          />
        </Row>
        <Button icon="play" type="submit" testId="sweep-begin" disabled={wrong || agents === 0}>
          {t("sweep.begin", { count: agents * (readWhole(moments) ?? 0) })}
        </Button>
        {wrong ? (
          <p className="sweep-wrong warning" id="sweep-seconds-wrong" role="alert">
            {t("sweep.seconds-wrong", { most: grouped(LONGEST_S) })}
          </p>
        ) : null}
      </form>
    </>
  );
}

function Progress({ done, total }: { done: number; total: number }) {
  const said = total === 0 ? t("sweep.preparing") : t("sweep.progress", { done: grouped(done), total: grouped(total) });
  return (
    <div className="sweep-asking row wrap" data-testid="sweep-progress">
      <progress aria-label={t("sweep.title")} max={Math.max(total, 1)} {...(total === 0 ? {} : { value: done })} />
      <span className="figures">{said}</span>
      <Button icon="square" testId="sweep-break-off" onClick={breakOff}>
        {t("sweep.break-off")}
      </Button>
    </div>
  );
}
