/** The choice of the mission's world: small pictures of all worlds that there are. */
import { useEffect, useState } from "react";

import { partsApi } from "../../api/parts";
import { decimal } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { changeWorld, sameWorld } from "../../model/commands/changeWorld";
import { execute, useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import type { WorldEntry } from "../../model/types";
import { reportError } from "../../session/document";
import { editWorld } from "../../session/world-edits";
import { primeWorld, useFiles } from "../../session/world-files";
import { openWorld } from "../../session/world-view";
import { Icon } from "../../theme";
import { Button } from "../../ui/Button";
import { awaitAnswer } from "../../ui/effects";
import { later } from "../../ui/later";

const WorldPicture = later(
  () => import("../../components/WorldPicture").then((chunk) => chunk.WorldPicture),
  reportError,
);

function useWorlds(): WorldEntry[] {
  const path = useStudio((studio) => studio.file.path);
  const read = useFiles((files) => files.read);
  const [worlds, setWorlds] = useState<WorldEntry[]>([]);
  useEffect(() => awaitAnswer(partsApi.worlds(path), setWorlds, reportError), [path, read]);
  return worlds;
}

/** "ring" of `ring.world.xml`. */
function stemOf(href: string): string {
  return (href === "" ? "empty.world.xml" : href).replace(/(\.world)?\.xml$/i, "");
}

function Card({ entry, chosen }: { entry: WorldEntry; chosen: boolean }) {
  const { href, world, label, help, shipped } = entry;
  const size = (mm: number) => decimal(mm / 1000);
  const starts = t("team.starts", { count: world?.starts.length ?? 0 });
  return (
    <label className="team-world card surface column" data-testid={`world-${stemOf(href)}`} title={text(help)}>
      <span className="team-world-picture card-picture muted centred">
        {world === null ? (
          <Icon name="map" size={24} />
        ) : (
          <WorldPicture world={world} agents={world.starts.map((start) => start.name)} />
        )}
      </span>
      <span className="card-title row">
        <input
          type="radio"
          name="team-world"
          checked={chosen}
          onChange={() => {
            primeWorld(href, world);
            execute(changeWorld(useStudio.getState().mission, href));
          }}
        />
        <strong>
          <bdi>{text(label, stemOf(href))}</bdi>
        </strong>
      </span>
      <small>
        {world === null
          ? t("team.world-broken")
          : t("team.world-size", { width: size(world.width_mm), height: size(world.height_mm), starts })}
        {shipped ? "" : ` · ${t("team.world-mine")}`}
      </small>
    </label>
  );
}

export function Worlds() {
  const chosen = useStudio((studio) => studio.mission.world);
  const own = useStudio((studio) => studio.mission.own_world ?? null);
  const worlds = useWorlds();
  const missing = own === null && worlds.length > 0 && !worlds.some((one) => sameWorld(one.href, chosen));
  return (
    <section className="team-part surface" aria-labelledby="team-world">
      <h2 id="team-world">{t("team.world")}</h2>
      <p className="team-note muted">
        {own === null ? null : `${t("world.mine")} `}
        <Button
          icon="pencil"

          testId="team-open-world"
          onClick={() => {
            openWorld();
            void editWorld();
          }}
        >
          {" "}
          {t("world.edit")}
        </Button>
      </p>
      {missing ? (
        <p className="team-note team-hint row wrap" role="status">
          <Icon name="triangle-alert" size={16} /> {t("team.world-missing", { name: chosen })}
        </p>
      ) : null}
      <div className="gap-2xl card-grid" role="radiogroup" aria-labelledby="team-world">
        {worlds.map((entry) => (
          <Card key={entry.href} entry={entry} chosen={own === null && sameWorld(entry.href, chosen)} />
        ))}
      </div>
    </section>
  );
}
