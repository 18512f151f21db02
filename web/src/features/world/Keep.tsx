/** At the end of the side: templates, and the mission's world as a file of its own, for other missions: its name, and why it cannot be. */
import { type ReactNode, useState } from "react";

import { t } from "../../i18n/words";
import { saveWorldFile } from "../../session/world-edits";
import { ownWorld } from "../../session/world-view";
import { Button } from "../../ui/Button";

export function Keep({ templates }: { templates: ReactNode }) {
  const [name, setName] = useState<string | null>(null);
  const [why, setWhy] = useState("");
  if (name === null) {
    return (
      <div className="world-keep column gap-m">
        <Button testId="save-world" onClick={() => setName(ownWorld()?.name ?? "")}>
          {t("world.save-file")}
        </Button>
        {templates}
      </div>
    );
  }
  return (
    <form
      className="world-keep column gap-m"
      onSubmit={(event) => {
        event.preventDefault();
        void saveWorldFile(name).then((wrong) => {
          setWhy(wrong);
          if (wrong === "") setName(null);
        });
      }}
    >
      <label className="field-title muted small-text rigid" htmlFor="world-file">
        {t("world.file-name")}
      </label>
      <span className="world-file row wide gap-xs">
        <input
          id="world-file"
          className="field"
          data-testid="world-file"
          autoFocus
          spellCheck={false}
          value={name}
          aria-invalid={why !== ""}
          aria-describedby={why === "" ? undefined : "world-file-why"}
          onChange={(event) => setName(event.target.value)}
          onKeyDown={(event) => {
            if (event.key !== "Escape") return;
            event.stopPropagation();
            setName(null);
          }}
        />
        <span dir="ltr">.world.xml</span>
      </span>
      {why === "" ? null : (
        <p className="field-wrong" id="world-file-why" role="alert">
          {why}
        </p>
      )}
      <Button type="submit" testId="world-file-save">
        {t("world.file-keep")}
      </Button>
    </form>
  );
}
