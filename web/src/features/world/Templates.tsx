/** Worlds to begin with: each a picture that takes the place of the world at a press; a maze for every number. */
import { useEffect, useState } from "react";

import type { Template } from "../../api/generated";
import { partsApi } from "../../api/parts";
import { WorldPicture } from "../../components/WorldPicture";
import { t } from "../../i18n/words";
import { text } from "../../model/texts";
import { drawnWorld } from "../../model/world/drawing";
import { reportError } from "../../session/document";
import { beginWith } from "../../session/world-edits";
import { awaitAnswer } from "../../ui/effects";
import { Tool } from "../../ui/Tool";
import { NumberField } from "./NumberField";

const MOST_SEED = 2 ** 32 - 1;

export function Templates({ done }: { done: () => void }) {
  const [seed, setSeed] = useState(1);
  const [templates, setTemplates] = useState<readonly Template[]>([]);
  useEffect(() => awaitAnswer(partsApi.templates(seed), setTemplates, reportError), [seed]);
  return (
    <section className="world-templates" aria-labelledby="world-templates" data-testid="world-templates">
      <header className="world-chosen-head row gap-xs">
        <h2 id="world-templates">{t("world.templates")}</h2>
        <Tool small icon="x" label={t("world.templates-close")} testId="world-templates-close" onClick={done} />
      </header>
      <p className="muted small-text">{t("world.templates-help")}</p>
      <ul>
        {templates.map(({ name, world }) => (
          <li key={name}>
            <button
              type="button"
              className="card framed column small-text hover gap-xs"
              data-testid={`template-${name}`}
              title={text(world.help, "")}
              onClick={() => {
                beginWith(world, text(world.label, name));
                done();
              }}
            >
              <WorldPicture world={drawnWorld(world)} agents={world.starts.map((start) => start.name)} />
              <span>{text(world.label, name)}</span>
            </button>
            {name === "maze" ? (
              <NumberField
                label={t("world.maze-seed")}
                unit=""
                value={seed}
                min={0}
                max={MOST_SEED}
                step={1}
                testId="world-maze-seed"
                keep={(value) => setSeed(Math.round(value))}
              />
            ) : null}
          </li>
        ))}
      </ul>
    </section>
  );
}
