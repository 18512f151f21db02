/** Everything in the world as a tree, kind by kind: for choosing with the keyboard and with a screen reader. */
import { type KeyboardEvent, useRef } from "react";

import { sentence, t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import type { OwnWorld } from "../../model/types";
import { KIND_ICONS, kindName, nameOf } from "../../model/world/names";
import { KINDS, partsOfKind, isSamePart, type PartReference, thingNamed } from "../../model/world/part-reference";
import { duplicateChosen, removeChosen } from "../../session/world-edits";
import { choose, useWorld } from "../../session/world-view";
import { Icon } from "../../theme";

export function Things({ world }: { world: OwnWorld }) {
  const chosen = useWorld((state) => state.chosen);
  const report = useStudio((studio) => studio.report);
  const tree = useRef<HTMLUListElement>(null);
  const wrong = (report?.problems ?? []).filter((one) => one.thing !== undefined && one.thing !== "");
  const groups = KINDS.map((kind) => ({ kind, count: partsOfKind(world, kind).length })).filter(
    ({ count }) => count > 0,
  );
  const things = groups.flatMap(({ kind, count }) =>
    Array.from({ length: count }, (_, at): PartReference => ({ kind, at })),
  );
  const first = chosen[0] ?? things[0];

  const focus = (thing: PartReference) => {
    requestAnimationFrame(() =>
      tree.current?.querySelector<HTMLElement>(`[data-thing="${thing.kind}:${String(thing.at)}"]`)?.focus(),
    );
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const at = things.findIndex((thing) => first !== undefined && isSamePart(thing, first));
    const to: Record<string, number> = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: things.length - 1 };
    const next = things[to[event.key] ?? -1];
    if (event.key in to) {
      event.preventDefault();
      event.stopPropagation();
      if (next === undefined) return;
      choose(event.shiftKey && !chosen.some((one) => isSamePart(one, next)) ? [next, ...chosen] : [next]);
      focus(next);
    } else if (event.key === "Delete") {
      event.preventDefault();
      event.stopPropagation();
      removeChosen();
      const left = things[Math.max(at - 1, 0)];
      if (left !== undefined) focus(left);
    } else if (event.key.toLowerCase() === "d" && (event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      duplicateChosen();
    } else if (event.key === "Enter") {
      event.preventDefault();
      document.querySelector<HTMLElement>('[data-testid="world-stage"]')?.focus();
    }
  };
  if (things.length === 0) return <p className="world-empty">{t("world.nothing")}</p>;
  return (
    <section aria-labelledby="world-things">
      <h2 id="world-things">{t("world.things-title")}</h2>
      <ul role="tree" aria-labelledby="world-things" aria-multiselectable="true" ref={tree} onKeyDown={onKeyDown}>
        {groups.map(({ kind, count }) => (
          <li key={kind} role="none">
            <span className="world-kind row muted tiny-text gap-s" aria-hidden="true">
              <Icon name={KIND_ICONS[kind]} size={14} /> {kindName(kind)}
            </span>
            <ul role="group" aria-label={kindName(kind)}>
              {Array.from({ length: count }, (_, at) => {
                const thing: PartReference = { kind, at };
                const problem = wrong.find((one) => {
                  const found = thingNamed(world, one.thing);
                  return found !== null && isSamePart(found, thing);
                });
                const label = nameOf(world, thing);
                return (
                  <li
                    key={at}
                    role="treeitem"
                    className="world-row finger row between gap-s"
                    data-thing={`${kind}:${String(at)}`}
                    data-testid={`thing-${kind}-${String(at)}`}
                    aria-selected={chosen.some((one) => isSamePart(one, thing))}
                    aria-label={problem === undefined ? label : `${label}. ${sentence(problem.message)}`}
                    tabIndex={first !== undefined && isSamePart(first, thing) ? 0 : -1}
                    onClick={(event) =>
                      choose(event.ctrlKey || event.metaKey || event.shiftKey ? [thing, ...chosen] : [thing])
                    }
                  >
                    <bdi>{label}</bdi>
                    {problem === undefined ? null : <Icon name="circle-x" size={14} className="tab-error" />}
                  </li>
                );
              })}
            </ul>
          </li>
        ))}
      </ul>
    </section>
  );
}
