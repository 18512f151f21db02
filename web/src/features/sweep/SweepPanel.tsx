/** The panel of the sweep: what is asked, how far it is, and the map. */
import { useEffect, useState } from "react";

import { grouped } from "../../i18n/numbers";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { useMembers } from "../../session/members";
import { useProblemList } from "../../session/problem-walk";
import { useWatch } from "../../session/watching";
import { Icon } from "../../theme";
import { Tool } from "../../ui/Tool";
import { Select } from "../../ui/Select";
import { useSweepPanel } from "./panel";
import { SweepMap } from "./SweepMap";
import { begin, breakOff, useSweep } from "./sweeping";
import "./sweep.css";

const MOMENTS = ["10", "25", "50", "100", "200"];
const LONGEST_S = 36_000;
const PAIRS = "kitrobot run … --fail-sweep --pairs";
const SHOWN_PROBLEMS = 3;

function close(): void {
  useSweepPanel.setState({ open: false });
}

/** One panel at a time stands above the bar. */
function useAlone(): void {
  useEffect(() => {
    useMembers.setState({ open: false });
    useWatch.getState().show(false);
    useProblemList.setState({ open: false });
    const ends = [useMembers, useWatch, useProblemList].map((store) =>
      store.subscribe(({ open }: { open: boolean }) => {
        if (open) close();
      }),
    );
    return () => ends.forEach((end) => end());
  }, []);
}

export function SweepPanel() {
  useAlone();
  const swept = useSweep((sweep) => sweep.swept);
  return (
    <section className="dock-panel sweep-panel" id="sweep-panel" data-testid="sweep" aria-label={t("sweep.title")}>
      <header className="dock-head">
        <h2>{t("sweep.title")}</h2>
        <Tool small icon="x" label={t("sweep.close")} titled={false} onClick={close} />
      </header>
      <div className="sweep-body">
        <Asking />
        <Refusal />
        {swept === null ? null : <SweepMap swept={swept} />}
      </div>
    </section>
  );
}

/** What is asked for; while the sweep is on, how far it is. */
function Asking() {
  const agents = useStudio((studio) => studio.mission.agents.length);
  const busy = useSweep((sweep) => sweep.busy);
  const swept = useSweep((sweep) => sweep.swept);
  const [moments, setMoments] = useState(() => String(swept?.map.moments.length ?? 25));
  const [typed, setTyped] = useState(() => String(swept?.asked.seconds ?? 600));
  const seconds = Number(typed.trim().replace(",", "."));
  const wrong = typed.trim() === "" || !(seconds > 0 && seconds <= LONGEST_S);
  if (agents === 0 && swept === null) return <p className="sweep-note">{t("sweep.nobody")}</p>;
  if (busy !== null) return <Progress {...busy} />;
  return (
    <>
      {swept === null ? (
        <p className="sweep-note">
          {t("sweep.what")} <Said text={t("sweep.pairs", { command: `\`${PAIRS}\`` })} />
        </p>
      ) : null}
      <form
        className="sweep-asking"
        onSubmit={(event) => {
          event.preventDefault();
          if (!wrong) begin(Number(moments), seconds);
        }}
      >
        <label>
          <span>{t("sweep.moments")}</span>
          <Select
            label={t("sweep.moments")}
            testId="sweep-moments"
            value={moments}
            options={MOMENTS.includes(moments) ? MOMENTS : [moments, ...MOMENTS]}
            keep={setMoments}
          />
        </label>
        <label>
          <span>{t("sweep.seconds")}</span>
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
        </label>
        <button type="submit" className="button" data-testid="sweep-begin" disabled={wrong || agents === 0}>
          <Icon name="play" size={16} />
          {t("sweep.begin", { count: agents * Number(moments) })}
        </button>
        {wrong ? (
          <p className="sweep-wrong" id="sweep-seconds-wrong" role="alert">
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
    <div className="sweep-asking" data-testid="sweep-progress">
      <progress aria-label={t("sweep.title")} max={Math.max(total, 1)} {...(total === 0 ? {} : { value: done })} />
      <span className="sweep-count">{said}</span>
      <button type="button" className="button" data-testid="sweep-break-off" onClick={breakOff}>
        <Icon name="square" size={16} />
        {t("sweep.break-off")}
      </button>
    </div>
  );
}

function Refusal() {
  const refused = useSweep((sweep) => sweep.refused);
  if (refused === null) return null;
  const errors = refused.problems.filter(({ severity }) => severity === "error");
  return (
    <div className="sweep-refused" role="alert" data-testid="sweep-refused">
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
          <button type="button" className="button" onClick={() => useProblemList.setState({ open: true })}>
            {t("sweep.problems")}
          </button>
        </>
      )}
    </div>
  );
}
