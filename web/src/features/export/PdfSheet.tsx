/** Asks what goes on paper or into a PDF, then leaves it to the browser. */
import { type FormEvent, useId } from "react";

import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { closeOverlay } from "../../session/document";
import { Sheet } from "../../ui/Sheet";
import { choosePrint, usePrintChoice } from "./choice";
import { printSheet } from "./print";

interface ChoiceProps {
  legend: string;
  /** What is chosen when it is not, and when it is. */
  words: readonly [string, string];
  testIds: readonly [string, string];
  chosen: boolean;
  choose: (chosen: boolean) => void;
}

function Choice({ legend, words, testIds, chosen, choose }: ChoiceProps) {
  const name = useId();
  return (
    <fieldset className="sheet-choice">
      <legend>{legend}</legend>
      {[false, true].map((value) => (
        <label key={String(value)}>
          <input
            type="radio"
            name={name}
            checked={chosen === value}
            data-testid={testIds[value ? 1 : 0]}
            onChange={() => choose(value)}
          />
          {words[value ? 1 : 0]}
        </label>
      ))}
    </fieldset>
  );
}

export function PdfSheet() {
  const { one, fit } = usePrintChoice();
  const name = useStudio((studio) => studio.activeProgram);
  const several = useStudio((studio) => studio.mission.programs.length > 1);
  const print = (event: FormEvent) => {
    event.preventDefault();
    closeOverlay();
    printSheet();
  };
  return (
    <Sheet title={t("pdf.title")} testId="pdf-dialog" onClose={closeOverlay}>
      <form onSubmit={print}>
        {several ? (
          <Choice
            legend={t("pdf.programs")}
            words={[t("pdf.all"), t("pdf.one", { name })]}
            testIds={["pdf-all", "pdf-one"]}
            chosen={one}
            choose={(one) => choosePrint({ one })}
          />
        ) : null}
        <Choice
          legend={t("pdf.graph")}
          words={[t("pdf.pages"), t("pdf.fit")]}
          testIds={["pdf-pages", "pdf-fit"]}
          chosen={fit}
          choose={(fit) => choosePrint({ fit })}
        />
        <p className="sheet-note">{t("pdf.how")}</p>
        <div className="sheet-foot">
          <button type="button" className="button" onClick={closeOverlay}>
            {t("open.cancel")}
          </button>
          <button type="submit" className="button button-ink" data-testid="pdf-print">
            {t("pdf.print")}
          </button>
        </div>
      </form>
    </Sheet>
  );
}
