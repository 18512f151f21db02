/** Find in all programs: a key of the page opens it (reach/key-table.ts), Enter goes to the next, Shift+Enter to the one before. */
import "./find.css";

import { useEffect, useMemo, useRef, useState } from "react";

import { t } from "../../i18n/words";
import { findIn, type Hit } from "../../model/find";
import { partsOf } from "../../model/parts";
import { useStudio } from "../../model/studio";
import { closeFind, useView } from "../../session/view";
import { Icon, Tile } from "../../theme";
import { Tool } from "../../ui/Tool";

/** Opens the program and selects what was found; the canvas brings it into view. */
function jump({ program, vertex }: Hit): void {
  const { setActiveProgram, select } = useStudio.getState();
  setActiveProgram(program);
  select([vertex]);
  // Another program is drawn first.
  requestAnimationFrame(() => useView.getState().viewport?.reveal(vertex));
}

export function Find() {
  const [query, setQuery] = useState("");
  /** -1: nothing was gone to yet. */
  const [at, setAt] = useState(-1);
  const list = useRef<HTMLUListElement>(null);
  const input = useRef<HTMLInputElement>(null);
  const { mission, catalogue, report } = useStudio();
  const hits = useMemo(
    () => findIn(mission.programs, (robot) => partsOf(catalogue, robot), report, query),
    [mission, catalogue, report, query],
  );
  const current = Math.min(at, hits.length - 1);

  useEffect(() => {
    input.current?.focus({ preventScroll: true });
  }, []);
  useEffect(() => {
    list.current?.querySelector(`#find-${String(current)}`)?.scrollIntoView({ block: "nearest" });
  }, [current]);

  const close = () => {
    closeFind();
    useView.getState().viewport?.focus();
  };
  const go = (index: number) => {
    const hit = hits[index];
    if (hit === undefined) return;
    setAt(index);
    jump(hit);
  };
  const step = (by: 1 | -1) => {
    if (hits.length > 0) go(current < 0 ? (by > 0 ? 0 : hits.length - 1) : (current + by + hits.length) % hits.length);
  };
  const count = current < 0 ? String(hits.length) : t("find.count", { at: current + 1, of: hits.length });

  return (
    <div
      className="find surface"
      role="search"
      aria-label={t("find.title")}
      data-testid="find"
      onKeyDown={(event) => {
        if (event.key === "Escape") close();
        else if (event.key === "Enter" && event.target === input.current) step(event.shiftKey ? -1 : 1);
        else if (event.key === "ArrowDown") step(1);
        else if (event.key === "ArrowUp") step(-1);
        else return;
        event.preventDefault();
        event.stopPropagation();
      }}
    >
      <div className="find-row row muted gap-xs">
        <Icon name="search" size={16} />
        <input
          ref={input}
          className="bare"
          type="text"
          role="combobox"
          aria-expanded={hits.length > 0}
          aria-controls="find-list"
          aria-activedescendant={current < 0 ? undefined : `find-${String(current)}`}
          aria-label={t("find.title")}
          placeholder={t("find.title")}
          data-testid="find-input"
          value={query}
          onChange={(event) => {
            setQuery(event.target.value);
            setAt(-1);
          }}
        />
        <span className="small-text nowrap figures" role="status">
          {query.trim() === "" ? "" : count}
        </span>
        <Tool small icon="chevron-up" label={t("find.previous")} onClick={() => step(-1)} />
        <Tool small icon="chevron-down" label={t("find.next")} onClick={() => step(1)} />
        <Tool small icon="x" label={t("graph.close")} onClick={close} />
      </div>
      {query.trim() !== "" && hits.length === 0 ? <p className="find-none muted">{t("find.none", { query })}</p> : null}
      <ul ref={list} id="find-list" role="listbox" aria-label={t("find.title")} hidden={hits.length === 0}>
        {hits.map((hit, index) => (
          <li
            key={`${hit.program} ${hit.vertex}`}
            className="finger option"
            id={`find-${String(index)}`}
            role="option"
            aria-selected={index === current}
            data-testid={`find-hit-${String(index + 1)}`}
            onPointerDown={(event) => event.preventDefault()}
            onClick={() => go(index)}
          >
            <Tile icon={hit.shape.icon} colour={hit.shape.colour} size={22} />
            <span className="ellipsis grow">
              {hit.name} <span className="muted small-text">{hit.aside}</span>
            </span>
            {mission.programs.length > 1 ? <span className="muted small-text">{hit.program}</span> : null}
          </li>
        ))}
      </ul>
    </div>
  );
}
