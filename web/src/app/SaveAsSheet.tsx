/** A name for the mission; a name that is taken is said under the field, with the choice to replace. */
import { type FormEvent, useState } from "react";

import { type Failure, whyRefused } from "../api/refusal";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { asMissionPath, closeOverlay, fileName, show, useDocument } from "../session/document";
import { hasPlace, saveAs } from "../session/saving";
import { Icon } from "../theme";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";

interface Refusal extends Failure {
  path: string;
  /** The revision that would be replaced, where the name is taken. */
  taken: string | null;
}

export function SaveAsSheet() {
  const workspace = useDocument((document) => document.session?.workspace ?? "");
  const [text, setText] = useState(() => {
    const { path } = useStudio.getState().file;
    return hasPlace(path) ? path : fileName();
  });
  const [refusal, setRefusal] = useState<Refusal | null>(null);
  const path = asMissionPath(text);

  const put = async (over: string) => {
    try {
      const answer = await saveAs(path, over);
      if (answer !== null) {
        const message = t("save.exists", { name: path });
        setRefusal({ path, message, help: "", taken: answer.taken });
      }
    } catch (cause) {
      setRefusal({ ...whyRefused(cause), path, taken: null });
    }
  };
  const onSubmit = (event: FormEvent) => {
    event.preventDefault();
    if (path !== "") void put("");
  };
  const shown = refusal?.path === path ? refusal : null;
  return (
    <Sheet title={t("save.title")} testId="save-dialog" onClose={closeOverlay}>
      <form onSubmit={onSubmit}>
        <Field label={t("save.name")}>
          <input
            className="field"
            data-testid="save-name"
            value={text}
            autoFocus
            spellCheck={false}
            autoComplete="off"
            aria-describedby="save-note"
            onFocus={(event) => event.target.setSelectionRange(0, text.replace(/\.krt$/, "").length)}
            onChange={(event) => setText(event.target.value)}
          />
        </Field>
        <p className="sheet-note muted small-text" id="save-note" role="status">
          {shown === null ? (
            t("save.where", { folder: workspace })
          ) : (
            <>
              <Icon name="triangle-alert" size={14} /> {shown.message} {shown.help}
            </>
          )}
        </p>
        <div className="sheet-foot flex gap-m justify-end">
          {shown?.taken === null || shown === null ? null : (
            <Button testId="save-replace" onClick={() => void put(shown.taken ?? "")}>
              {t("save.replace")}
            </Button>
          )}
          <Button onClick={() => show(null)}>{t("open.cancel")}</Button>
          <Button ink type="submit" testId="save" disabled={path === ""}>
            {t("save.save")}
          </Button>
        </div>
      </form>
    </Sheet>
  );
}
