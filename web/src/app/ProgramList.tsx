/** Every program of the mission in a list that can be searched, for those whose tabs are not in view. */
import { type KeyboardEvent, useEffect, useId, useRef, useState } from "react";
import { createPortal } from "react-dom";

import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { closeTeam } from "../session/team-view";
import { listen } from "../ui/effects";

interface ProgramListProps {
  /** From the edge where a line begins, and from the top, px of the window: the list stands there, or as near as it fits. */
  at: { x: number; y: number };
  onLeave: () => void;
  onClose: () => void;
}

/** In the main landmark, outside of the row of tabs, whose keys are not the list's. */
export function ProgramList(props: ProgramListProps) {
  return createPortal(<Open {...props} />, document.querySelector("main") ?? document.body);
}

function Open({ at, onLeave, onClose }: ProgramListProps) {
  const programs = useStudio((studio) => studio.mission.programs);
  const active = useStudio((studio) => studio.activeProgram);
  const [wanted, setWanted] = useState("");
  const letters = wanted.trim().toLocaleLowerCase();
  const found = programs.filter(({ name }) => name.toLocaleLowerCase().includes(letters));
  const [picked, setPicked] = useState(active);
  const place = Math.max(
    found.findIndex(({ name }) => name === picked),
    0,
  );
  const root = useRef<HTMLDivElement>(null);
  const list = useRef<HTMLUListElement>(null);
  const id = useId();

  useEffect(() => {
    const outside = (event: PointerEvent) => {
      if (event.target instanceof Node && root.current?.contains(event.target) === true) return;
      onLeave();
    };
    return listen(document, { pointerdown: outside }, { capture: true });
  }, [onLeave]);
  useEffect(() => {
    list.current?.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: "nearest" });
  }, [place, letters]);

  const choose = (name: string) => {
    closeTeam();
    useStudio.getState().setActiveProgram(name);
    onClose();
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const last = found.length - 1;
    const steps: Record<string, number> = {
      ArrowDown: place === last ? 0 : place + 1,
      ArrowUp: place === 0 ? last : place - 1,
      PageDown: Math.min(place + 8, last),
      PageUp: Math.max(place - 8, 0),
    };
    const next = steps[event.key];
    if (next !== undefined) setPicked(found[next]?.name ?? "");
    else if (event.key === "Enter") {
      const chosen = found[place];
      if (chosen !== undefined) choose(chosen.name);
    } else if (event.key === "Escape") onClose();
    else if (event.key === "Tab") {
      onClose();
      return;
    } else {
      // What is typed goes into the field, and nowhere else.
      event.stopPropagation();
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <div
      className="program-list surface column"
      ref={root}
      style={{ "--x": `${String(at.x)}px`, top: at.y } as React.CSSProperties}
    >
      <input
        className="field"
        role="combobox"
        aria-label={t("tabs.find")}
        placeholder={t("tabs.find")}
        aria-expanded
        aria-controls={id}
        aria-autocomplete="list"
        {...(found.length > 0 ? { "aria-activedescendant": `${id}-${String(place)}` } : {})}
        autoFocus
        value={wanted}
        data-testid="program-find"
        onChange={(event) => setWanted(event.target.value)}
        onKeyDown={onKeyDown}
      />
      <ul role="listbox" id={id} aria-label={t("tabs.all")} ref={list} data-testid="program-list">
        {found.map(({ name }, index) => (
          <li
            key={name}
            id={`${id}-${String(index)}`}
            role="option"
            className="menu-item row nowrap"
            aria-selected={index === place}
            {...(name === active ? { "aria-current": true } : {})}
            title={name}
            data-testid={`program-option-${name}`}
            onClick={() => choose(name)}
          >
            <bdi>{name}</bdi>
          </li>
        ))}
      </ul>
      {found.length === 0 ? <p role="status">{t("tabs.none")}</p> : null}
    </div>
  );
}
