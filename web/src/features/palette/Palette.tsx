/** The parts that a program is made of: drag one onto the graph, or click it to add it at the selection. */
import "./palette.css";

import { type KeyboardEvent, useEffect, useMemo, useRef, useState } from "react";

import { mirrored } from "../../i18n/language";
import { t } from "../../i18n/words";
import { elsewhere } from "../../model/part-search";
import { partsOf } from "../../model/parts";
import { programInView, useStudio } from "../../model/studio";
import { reportError } from "../../session/document";
import { setBin, useDrag } from "../../session/drag";
import { addPart } from "../../session/edits";
import { useKit } from "../../session/kit";
import { useReveal } from "../../session/reveal";
import { newVariable, useVariables } from "../../session/variables";
import { Icon } from "../../theme";
import { later } from "../../ui/later";
import { PaletteRow } from "./PaletteRow";
import { PaletteTabs, sectionId } from "./PaletteTabs";
import { RobotButton } from "./RobotButton";
import { actionsOf, rowKey } from "./row-actions";
import { partsOfKit, type Row, rowOfPart, tabsOf } from "./tree";
import { VariableMenu } from "./VariableMenu";

const KitNote = later(() => import("./KitNote").then((chunk) => chunk.KitNote), reportError);
const VariableForm = later(() => import("./VariableForm").then((chunk) => chunk.VariableForm), reportError);

export function Palette() {
  const form = useVariables((state) => state.form);
  const robot = useStudio((state) => programInView(state)?.robot ?? "");
  const catalogue = useStudio((state) => state.catalogue);
  const [query, setQuery] = useState("");
  const [at, setAt] = useState("");
  const list = useRef<HTMLDivElement>(null);
  const bin = useRef<HTMLDivElement>(null);
  const find = useRef<HTMLInputElement>(null);
  const kit = useKit((state) => state.kit);
  const parts = partsOf(catalogue, robot);
  const tabs = useMemo(() => tabsOf(partsOfKit(parts, kit, robot), query), [parts, kit, robot, query]);
  const items = useMemo(() => tabs.flatMap(({ rows }) => rows), [tabs]);
  const current = items.some((row) => row.key === at) ? at : (items[0]?.key ?? "");

  const rowElement = (key: string) => list.current?.querySelector<HTMLElement>(`[data-row="${CSS.escape(key)}"]`);

  useEffect(
    () =>
      useReveal.subscribe(({ element }) => {
        const key = rowOfPart(element);
        setQuery("");
        setAt(key);
        // The row is there once the palette is drawn with it.
        requestAnimationFrame(() => {
          const found = rowElement(key);
          found?.scrollIntoView({ block: "nearest" });
          found?.focus({ preventScroll: true });
        });
      }),
    [robot],
  );

  /** The row that has the focus, by its key and its place; null when it is elsewhere. */
  const focused = useRef<{ key: string; index: number } | null>(null);
  useEffect(() => {
    const before = focused.current;
    if (before === null || document.activeElement !== document.body || items.some((row) => row.key === before.key))
      return;
    // The row is gone, with its part: the one in its place has the focus then.
    const next = items[Math.min(before.index, items.length - 1)];
    if (next !== undefined) rowElement(next.key)?.focus();
  });

  const go = (row: Row | undefined) => {
    if (row === undefined) return;
    setAt(row.key);
    rowElement(row.key)?.focus();
  };

  const onKeyDown = (event: KeyboardEvent) => {
    const index = items.findIndex((row) => row.key === current);
    const row = items[index];
    if (row === undefined) return;
    const tab = tabs.findIndex(({ rows }) => rows.includes(row));
    const actions = actionsOf(row, robot);
    const [onwards, backwards] = mirrored() ? ["ArrowLeft", "ArrowRight"] : ["ArrowRight", "ArrowLeft"];
    if (event.key === "ArrowDown") go(items[index + 1]);
    else if (event.key === "ArrowUp") go(items[index - 1]);
    else if (event.key === "Home") go(items[0]);
    else if (event.key === "End") go(items.at(-1));
    else if (event.key === onwards) go(tabs[tab + 1]?.rows[0]);
    else if (event.key === backwards) go(tabs[tab - 1]?.rows[0]);
    else if (event.key === "/") find.current?.focus();
    else if (actions !== null && rowKey(event, actions)) event.stopPropagation();
    else if (event.key === "Enter" || event.key === " ") {
      if (row.kind === "new") newVariable();
      else if (row.kind === "part") addPart(row.shape.element);
    } else return;
    event.preventDefault();
  };

  useEffect(() => {
    setBin(bin.current);
    return () => setBin(null);
  }, []);

  const searching = query.trim() !== "";
  return (
    <div className="palette column relative" ref={bin}>
      <Bin />
      <div className="palette-head rigid column">
        <RobotButton />
        {kit === null ? null : <KitNote />}
        <label className="palette-find row muted rigid">
          <Icon name="search" />
          <input
            ref={find}
            className="bare"
            type="search"
            aria-label={t("parts.find")}
            placeholder={t("parts.find-example")}
            data-testid="part-find"
            value={query}
            onChange={(event) => setQuery(event.target.value)}
            onKeyDown={(event) => {
              if (event.key === "Escape") setQuery("");
              else if (event.key === "ArrowDown") go(items[0]);
              else if (event.key === "Enter") {
                const first = items.find((row) => row.kind === "part");
                if (first !== undefined && query !== "") addPart(first.shape.element);
              } else return;
              event.preventDefault();
            }}
          />
          <kbd aria-hidden="true">/</kbd>
        </label>
        {searching ? null : <PaletteTabs tabs={tabs} list={list} onChoose={(tab) => setAt(tab.rows[0]?.key ?? "")} />}
      </div>
      {tabs.length === 0 ? <NoneFound query={query} robot={robot} /> : null}
      <div
        ref={list}
        className="palette-list"
        role="tree"
        aria-label={t("parts.tree")}
        onKeyDown={onKeyDown}
        onBlur={(event) => {
          // A row that goes with its part takes the focus along; that is no leaving.
          if (event.relatedTarget !== null || event.target.isConnected) focused.current = null;
        }}
      >
        {tabs.map((tab) => (
          <div key={tab.name} id={sectionId(tab.name)} className="palette-section" role="group" aria-label={tab.label}>
            <div className="palette-heading muted" role="presentation">
              {tab.label}
            </div>
            {tab.rows.map((row) => (
              <PaletteRow
                key={row.key}
                row={row}
                robot={robot}
                focused={row.key === current}
                onFocus={() => {
                  setAt(row.key);
                  focused.current = { key: row.key, index: items.indexOf(row) };
                }}
                onNamed={(name) => {
                  const key = `object variable ${name}`;
                  setAt(key);
                  requestAnimationFrame(() => rowElement(key)?.focus());
                }}
              />
            ))}
          </div>
        ))}
      </div>
      {form === null ? null : <VariableForm key={`${form.robot} ${form.was}`} {...form} />}
      <VariableMenu />
    </div>
  );
}

/** Says that nothing is called so, and which other robots can do it. */
function NoneFound({ query, robot }: { query: string; robot: string }) {
  const catalogue = useStudio((state) => state.catalogue);
  const others = elsewhere(catalogue, partsOf(catalogue, robot), query);
  return (
    <div className="palette-none muted" role="status" data-testid="parts-none">
      <p>{t("parts.none", { query })}</p>
      {others.map((one) => (
        <p key={one.robot}>{t("parts.elsewhere", { robot: one.robot, parts: one.parts.join(" · ") })}</p>
      ))}
    </div>
  );
}

/** While parts of the graph are dragged: what is dropped on the list of parts is thrown away. */
function Bin() {
  const open = useDrag(({ payload }) => payload?.kind === "vertices");
  const away = useDrag((drag) => drag.away);
  if (!open) return null;
  return (
    <div
      className="palette-bin column bold muted justify-centre text-centre"
      data-away={away}
      data-testid="parts-bin"
      aria-hidden="true"
    >
      <Icon name="trash-2" size={24} />
      {t("parts.throw-away")}
    </div>
  );
}
