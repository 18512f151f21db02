/** Asks what goes on paper or into a PDF, then leaves it to the browser. */
import type { FormEvent } from "react";

import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { closeOverlay } from "../../session/document";
import { RadioPair } from "../../ui/RadioPair";
import { Sheet } from "../../ui/Sheet";
import { choosePrint, usePrintChoice } from "./choice";
import { printSheet } from "./print";

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
          <RadioPair
            legend={t("pdf.programs")}
            words={[t("pdf.all"), t("pdf.one", { name })]}
            testIds={["pdf-all", "pdf-one"]}
            second={one}
            choose={(one) => choosePrint({ one })}
          />
        ) : null}
        <RadioPair
          legend={t("pdf.graph")}
          words={[t("pdf.pages"), t("pdf.fit")]}
          testIds={["pdf-pages", "pdf-fit"]}
          second={fit}
          choose={(fit) => choosePrint({ fit })}
        />
        <p className="sheet-note">{t("pdf.how")}</p>
        <div className="sheet-foot flex gap-m justify-end">
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
