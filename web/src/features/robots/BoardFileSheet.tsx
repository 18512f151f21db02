/** Asks for the MicroPython that comes along in a file for a board's drive; one that was chosen before is offered again. */
import { useRef, useState } from "react";

import type { KitEntry } from "../../api/generated";
import { type Failure, whyRefused } from "../../api/refusal";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import { Sheet } from "../../ui/Sheet";
import { chooseFirmware, dropFirmwareQuestion, saveWithFirmware, useFirmwareQuestion } from "./board-file";
import { Act, TroubleBox } from "./parts";

export function BoardFileSheet() {
  const { kit, file } = useFirmwareQuestion();
  return kit === null ? null : <Question kit={kit} file={file} />;
}

function Question({ kit, file }: { kit: KitEntry; file: File | null }) {
  const [wrong, setWrong] = useState<Failure | null>(null);
  const [busy, setBusy] = useState(false);
  const chooser = useRef<HTMLInputElement>(null);
  const save = () => {
    if (file === null) return;
    setBusy(true);
    setWrong(null);
    saveWithFirmware(kit, file)
      .catch((cause: unknown) => setWrong(whyRefused(cause)))
      .finally(() => setBusy(false));
  };
  return (
    <Sheet title={t("board-file.title")} testId="board-file" onClose={dropFirmwareQuestion}>
      <p className="sheet-note">
        <Said text={t("board-file.about", { kit: text(kit.label, kit.name) })} />{" "}
        {kit.firmware === "" ? null : (
          <a className="robot-link start-text medium" href={kit.firmware} target="_blank" rel="noreferrer">
            {t("boards.firmware")}
          </a>
        )}
      </p>
      <div className="robot-flash gap-m">
        {file === null ? null : (
          <p data-testid="board-file-kept">
            <Said text={t("board-file.kept", { name: file.name })} />
          </p>
        )}
        {wrong === null ? null : <TroubleBox said={wrong} testId="board-file-trouble" />}
        <div className="robot-acts row wrap slim">
          <input
            ref={chooser}
            className="only-spoken"
            type="file"
            accept=".uf2"
            tabIndex={-1}
            aria-hidden="true"
            data-testid="board-file-firmware"
            onChange={(event) => {
              const chosen = event.target.files?.[0];
              if (chosen === undefined) return;
              setWrong(null);
              chooseFirmware(chosen);
            }}
          />
          <Act
            icon="upload"
            label={t(file === null ? "board-file.choose" : "board-file.other")}
            testId="board-file-choose"
            disabled={busy}
            onPress={() => chooser.current?.click()}
          />
          <Act
            ink
            icon="folder-down"
            label={t(busy ? "board-file.saving" : "board-file.save")}
            testId="board-file-save"
            disabled={busy || file === null}
            onPress={save}
          />
        </div>
      </div>
    </Sheet>
  );
}
