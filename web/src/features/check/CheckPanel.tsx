/** The panel of the check: what is asked, how far it is, the table of answers, and the run that breaks a property. */
import { useState } from "react";

import { DockPanel } from "../../components/DockPanel";
import { Refusal } from "../../components/Refusal";
import { decimal, grouped, readWhole } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { Button } from "../../ui/Button";
import { Row } from "../../ui/Row";
import { Select } from "../../ui/Select";
import { AnswerTable } from "./AnswerTable";
import { BrokenRun } from "./BrokenRun";
import { FAILURE_COUNTS, kindChoices, kindsOf, USUAL, valueOf } from "./kinds";
import { Properties } from "./Properties";
import { beginWalk, useStateWalk } from "./state-walk";
import { assumptionWords, Limits, Verdict } from "./Verdict";
import { answerAt, begin, breakOff, useCheck } from "./check-session";
import { WalkedState } from "./WalkedState";
import "./check.css";

const SECONDS = ["10", "60", "300", "1800"];
const EXACT = "exact";
const ROUGH = "rough";
const MEGA = 1_000_000;

export function CheckPanel() {
  const refused = useCheck((check) => check.refused);
  const asked = useCheck((check) => check.asked);
  const open = useCheck((check) => check.open);
  const answered = useCheck((check) => answerAt(check, check.open) !== null);
  const walks = useStateWalk((walk) => walk.wanted !== null);
  return (
    <DockPanel id="check-panel" testId="check" title={t("check.title")} close={t("check.close")} tools={<Asking />}>
      <div className="check-body flex" data-run={walks || answered}>
        <div className="check-answers column grow scroll gap-m">
          <Refusal refused={refused} />
          {asked === null ? <p className="check-what prose muted">{t("check.what")}</p> : <Answers />}
          <WalkEntry />
          <Properties />
        </div>
        {walks ? (
          <WalkedState />
        ) : answered && open !== null ? (
          <BrokenRun key={`${String(open.row)} ${String(open.column)}`} cell={open} />
        ) : null}
      </div>
    </DockPanel>
  );
}

/** The states of the mission one by one, as it is drawn now. */
function WalkEntry() {
  const agents = useStudio((studio) => studio.mission.agents.length);
  return (
    <p className="check-walk">
      <Button
        icon="step-forward"
        testId="walk-begin"
        disabled={agents === 0}
        onClick={() => beginWalk({ timing: "free", failures: 0 })}
      >
        {t("walk.title")}
      </Button>
    </p>
  );
}

function Answers() {
  const columns = useCheck((check) => check.columns.length);
  const busy = useCheck((check) => check.busy);
  const changed = useStudio(({ mission }) => mission !== useCheck.getState().asked?.mission);
  if (columns === 0) return busy ? <p className="check-what prose muted">{t("check.begins")}</p> : null;
  return (
    <>
      <Verdict />
      {changed ? <p className="warning">{t("check.changed")}</p> : null}
      <AnswerTable />
      <Limits />
    </>
  );
}

/** What is asked for; while the check is on, how far it is. */
function Asking() {
  const agents = useStudio((studio) => studio.mission.agents.length);
  const busy = useCheck((check) => check.busy);
  const asked = useCheck((check) => check.asked);
  const [failures, setFailures] = useState(() => String(asked?.failures ?? 0));
  const [kinds, setKinds] = useState(() => valueOf(asked?.kinds ?? USUAL));
  const [seconds, setSeconds] = useState(() => String(asked?.seconds ?? 60));
  const [search, setSearch] = useState(() => (asked?.approximate === true ? ROUGH : EXACT));
  if (busy) return <Progress />;
  return (
    <form
      className="check-asking row wrap small-text grow justify-end"
      onSubmit={(event) => {
        event.preventDefault();
        begin(readWhole(failures) ?? 0, kindsOf(kinds), readWhole(seconds) ?? 0, search === ROUGH);
      }}
    >
      <Row label={t("check.failures")}>
        <Select
          label={t("check.failures")}
          testId="check-failures"
          value={failures}
          options={FAILURE_COUNTS}
          keep={setFailures}
        />
      </Row>
      {failures === "0" ? null : (
        <Row label={t("check.kinds")}>
          <Select label={t("check.kinds")} testId="check-kinds" value={kinds} options={kindChoices()} keep={setKinds} />
        </Row>
      )}
      <Row label={t("check.seconds")}>
        <Select
          label={t("check.seconds")}
          testId="check-seconds"
          value={seconds}
          options={SECONDS.map((one) => [one, t("check.seconds-of", { seconds: grouped(readWhole(one) ?? 0) })])}
          keep={setSeconds}
        />
      </Row>
      <Row label={t("check.search")}>
        <Select
          label={t("check.search")}
          testId="check-search"
          value={search}
          options={[EXACT, ROUGH].map((one) => [one, t(one === ROUGH ? "check.rough" : "check.exact")])}
          keep={setSearch}
        />
      </Row>
      <Button icon="clipboard-check" type="submit" testId="check-begin" disabled={agents === 0}>
        {asked === null ? t("check.begin") : t("check.again")}
      </Button>
      {agents === 0 ? <span className="muted">{t("check.nobody")}</span> : null}
    </form>
  );
}

function Progress() {
  const progress = useCheck((check) => check.progress);
  const stopping = useCheck((check) => check.stopping);
  return (
    <div className="check-asking row wrap small-text grow justify-end" data-testid="check-progress">
      <span className="check-count figures">{progress === null ? t("check.preparing") : said(progress)}</span>
      <Button icon="square" testId="check-stop" disabled={stopping} onClick={breakOff}>
        {t("check.stop")}
      </Button>
    </div>
  );
}

type Told = NonNullable<ReturnType<typeof useCheck.getState>["progress"]>;

function said(progress: Told): string {
  const { states, depth, seconds, memory } = progress;
  const pace = seconds > 0 ? Math.round(states / seconds) : 0;
  const words = t("check.progress", {
    assumption: assumptionWords(progress),
    states: grouped(states),
    depth: grouped(depth),
    pace: grouped(pace),
  });
  return memory === 0 ? words : t("check.progress-memory", { words, memory: decimal(Math.round(memory / MEGA)) });
}
