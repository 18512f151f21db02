/** The parts of a robot by hand: a button for each step, what is to be seen, its value, and what to look for when nothing happens. */
import type { Failure } from "../../api/refusal";
import { Said } from "../../i18n/Said";
import { languageInUse, t } from "../../i18n/words";
import { valueWords } from "../../model/words";
import { Tool } from "../../ui/Tool";
import { endBench, tryStep } from "./actions";
import { useBoards } from "./boards";
import { Act, TroubleBox } from "./parts";
import type { BenchStep, Board } from "./wire";

/** A text of the server in the language of the page. */
function inWords(texts: Record<string, string>): string {
  return texts[languageInUse()] ?? texts[""] ?? "";
}

function nameOf(part: { part: string; label: Record<string, string> }): string {
  return inWords(part.label) || part.part;
}

function Step({
  address,
  at,
  step,
  going,
  value,
  slow,
  failure,
}: {
  address: string;
  at: number;
  step: BenchStep;
  going: boolean;
  value: number | null;
  slow: boolean;
  failure: Failure | undefined;
}) {
  const name = nameOf(step);
  const trouble = inWords(step.trouble);
  return (
    <li className="bench-step" data-testid="bench-step" data-going={going} data-failed={failure !== undefined}>
      <Tool
        small
        icon={going ? "square" : "play"}
        label={t(going ? "boards.try-end" : "boards.try-begin", { part: name })}
        testId="bench-try"
        aria-pressed={going}
        onClick={() => tryStep(address, going ? null : at)}
      />
      <div className="bench-words slim">
        <p className="bench-name wrap flex">
          <strong>{name}</strong>
          {step.call === "" ? null : <code dir="ltr">{step.call}</code>}
          {going && value !== null ? (
            <output className="to-end bold" data-testid="bench-value">
              {valueWords(step.reads, value)}
            </output>
          ) : null}
        </p>
        <p>
          <Said text={inWords(step.seen)} />
        </p>
        {going && slow ? <p data-testid="bench-slow">{t("boards.try-slow")}</p> : null}
        {failure === undefined ? null : <TroubleBox said={failure} testId="bench-failure" />}
        {trouble === "" ? null : (
          <details>
            <summary>{t("boards.try-trouble")}</summary>
            <p>
              <Said text={trouble} />
            </p>
          </details>
        )}
      </div>
    </li>
  );
}

export function TryParts({ board }: { board: Board }) {
  const { address, bench } = board;
  const known = useBoards((state) => state.steps[address]);
  if (known === undefined || bench === null) return null;
  return (
    <section className="bench" aria-label={t("boards.try")} data-testid="bench">
      <p className="bold below">{t("boards.try-wheels")}</p>
      <ol>
        {known.steps.map((step, at) => (
          <Step
            key={`${step.part} ${step.call}`}
            address={address}
            at={at}
            step={step}
            going={bench.step === at}
            value={bench.value}
            slow={bench.slow}
            failure={bench.failed.find((one) => one.step === at)}
          />
        ))}
      </ol>
      {known.left_out.map((part) => (
        <p key={part.part} className="robots-note muted" data-testid="bench-left-out">
          {t("boards.try-left-out", { part: nameOf(part) })} <Said text={part.why} />
        </p>
      ))}
      <Act icon="check" label={t("boards.try-done")} testId="bench-done" onPress={() => endBench(address)} />
    </section>
  );
}
