/**
 * The world in the place of the canvas: the place itself to draw on, beside it a list of what is there and the numbers of
 * what is chosen.
 *
 * A world of a file is shown and can be copied into the mission; only a world of the mission's own is changed.
 */
import { useEffect, useState } from "react";

import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { openRoom } from "../../session/narrow";
import { isLive, useRun } from "../../session/run";
import { closeTeam } from "../../session/team-view";
import { editWorld } from "../../session/world-edits";
import { chosenIn, choose, ownWorld, takeTool, useWorld } from "../../session/world-view";
import { Fields } from "./Fields";
import { Keep } from "./Keep";
import { Stage } from "./Stage";
import { Things } from "./Things";
import { Templates } from "./Templates";
import { Tools } from "./Tools";
import { Button } from "../../ui/Button";
import "./world.css";

function FromFile({ templates }: { templates: () => void }) {
  const world = useStudio((studio) => studio.world);
  const href = useStudio((studio) => studio.mission.world);
  return (
    <section aria-labelledby="world-from-file">
      <h2 id="world-from-file">{world?.name ?? t("world.tab")}</h2>
      <p>{href === "" ? t("world.of-empty") : t("world.of-file", { file: href })}</p>
      <p>{t("world.copy-help")}</p>
      <div className="world-choices wrap">
        <Button testId="edit-world" onClick={() => void editWorld()}>
          {t("world.edit")}
        </Button>
        <OpenTemplates open={templates} />
      </div>
    </section>
  );
}

function OpenTemplates({ open }: { open: () => void }) {
  return (
    <Button testId="world-templates-open" onClick={open}>
      {t("world.templates-open")}
    </Button>
  );
}

export default function World() {
  const [templates, setTemplates] = useState(false);
  const openTemplates = () => setTemplates(true);
  const own = useStudio((studio) => studio.mission.own_world ?? null);
  const said = useWorld((state) => state.said);
  const held = useWorld((state) => state.tool !== null);
  useEffect(() => openRoom(null), []);
  useEffect(() => {
    // Whoever takes a tool wants to change the world: that of a file is copied for it.
    if (!held || own !== null) return;
    void editWorld().then(() => {
      if (ownWorld() === null) takeTool(null);
    });
  }, [held, own]);
  // Who starts a run wants to see it.
  useEffect(
    () =>
      useRun.subscribe((now, before) => {
        if (isLive(now.status) && !isLive(before.status)) closeTeam();
      }),
    [],
  );
  useEffect(() => {
    const { chosen } = useWorld.getState();
    const there = chosenIn(own, chosen);
    if (there.length !== chosen.length) choose(there);
  }, [own]);
  return (
    <div className="world cover" id="world-panel" role="tabpanel" aria-label={t("world.tab")} data-testid="world">
      <div className="column slim fill">
        <Tools />
        <Stage />
      </div>
      <div className="world-side column scroll">
        {templates ? (
          <Templates done={() => setTemplates(false)} />
        ) : own === null ? (
          <FromFile templates={openTemplates} />
        ) : (
          <>
            <Fields world={own} />
            <Things world={own} />
            <Keep templates={<OpenTemplates open={openTemplates} />} />
          </>
        )}
      </div>
      <p className="only-spoken" role="status">
        {said}
      </p>
    </div>
  );
}
