/** A part that is used is deleted: where it is used, and what becomes of its vertices. */
import { useState } from "react";

import { t } from "../../i18n/words";
import { removeConstructor, usesOfConstructor } from "../../model/commands/changeOwn";
import { dissolvePart } from "../../model/commands/ownParts";
import { execute, useStudio } from "../../model/studio";
import type { Program } from "../../model/types";
import { reveal } from "../../session/actions";
import { closeSheet } from "../../session/custom-blocks";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { Sheet } from "../../ui/Sheet";
import { ownPart } from "./naming";
import { whyNot } from "./SaveSheet";
import { partsApi } from "./server";

export function DeleteSheet({ name }: { name: string }) {
  const mission = useStudio((studio) => studio.mission);
  const [failure, setFailure] = useState("");
  const part = ownPart(mission, name);
  if (part === undefined) return null;
  const uses = usesOfConstructor(mission, name);
  const count = uses.reduce((sum, { vertices }) => sum + vertices.length, 0);

  const dissolve = async () => {
    const { file, files } = useStudio.getState();
    const users = new Set(uses.map(({ program }) => program));
    const robots = mission.programs.filter((one) => users.has(one.name)).map((one) => one.robot);
    try {
      const drawings = new Map<string, Program>();
      for (const robot of new Set(robots)) {
        const { drawing } = await partsApi.read(mission, file.path, robot, part);
        if (drawing !== null) drawings.set(robot, drawing);
      }
      if (useStudio.getState().mission !== mission) {
        setFailure(t("own.changed"));
        return;
      }
      execute(dissolvePart(mission, files, name, drawings));
      closeSheet();
    } catch (cause) {
      setFailure(whyNot(cause));
    }
  };
  const leave = () => {
    execute(removeConstructor(mission, name));
    closeSheet();
  };
  return (
    <Sheet title={t("own.delete-title", { name })} testId="own-delete" onClose={closeSheet}>
      <p>{t("own.used", { count })}</p>
      <ul>
        {uses.map(({ program, vertices }) => (
          <li key={program}>
            <button
              type="button"
              className="open-entry row start-text gap-xl hover"
              data-testid={`own-use-${program}`}
              onClick={() => {
                closeSheet();
                reveal(program, vertices);
              }}
            >
              <Icon name="search" size={16} />
              {t("own.used-in", { program, count: vertices.length })}
            </button>
          </li>
        ))}
      </ul>
      <p className="sheet-note muted small-text">{t("own.delete-how")}</p>
      <p className="own-failure row small-text gap-s" role="status">
        {failure}
      </p>
      <div className="sheet-foot flex gap-m justify-end">
        <Button onClick={closeSheet}>{t("open.cancel")}</Button>
        <Button testId="own-leave" onClick={leave}>
          {t("own.leave")}
        </Button>
        <Button ink testId="own-dissolve" onClick={() => void dissolve()}>
          {t("own.dissolve")}
        </Button>
      </div>
    </Sheet>
  );
}
