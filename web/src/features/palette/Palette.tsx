/** The tree of parts that a program is made of: drag one onto the graph, or click it to add it at the selection. */
import "./palette.css";

import { type KeyboardEvent, useEffect, useMemo, useRef, useState } from "react";

import { mirrored } from "../../i18n/language";
import { t } from "../../i18n/words";
import { partsOf } from "../../model/parts";
import { programInView, useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import type { RobotObject } from "../../model/types";
import { valueWords } from "../../model/words";
import { isOwn } from "../../session/custom-blocks";
import { complain } from "../../session/document";
import { beginDrag, justDragged } from "../../session/drag";
import { addPart } from "../../session/edits";
import { useReveal } from "../../session/reveal";
import { useRun, watchedAgent } from "../../session/run";
import { newVariable, useVariables, variableKey } from "../../session/variables";
import { Icon, Tile } from "../../theme";
import { later } from "../../ui/later";
import { ownHandlers, ownKey, restOnOwn } from "./custom-row";
import { CustomBlockMore } from "./CustomBlockMore";
import { RobotButton } from "./RobotButton";
import { type Folded, type Row, rowsOf, unfoldedFor } from "./tree";
import { variableHandlers } from "./variable-row";
import { VariableMenu } from "./VariableMenu";
import { VariableName } from "./VariableName";

const VariableForm = later(() => import("./VariableForm").then((chunk) => chunk.VariableForm), complain);

export function Palette() {
  const form = useVariables((state) => state.form);
  const robot = useStudio((state) => programInView(state)?.robot ?? "");
  const catalogue = useStudio((state) => state.catalogue);
  const [query, setQuery] = useState("");
  const [folded, setFolded] = useState<Folded>({});
  const [at, setAt] = useState("");
  const tree = useRef<HTMLDivElement>(null);
  const find = useRef<HTMLInputElement>(null);
  const parts = partsOf(catalogue, robot);
  const rows = useMemo(() => rowsOf(parts, query, folded), [parts, query, folded]);
  const items = rows.filter((row) => row.kind !== "heading");
  const current = items.some((row) => row.key === at) ? at : (items[0]?.key ?? "");

  useEffect(
    () =>
      useReveal.subscribe(({ element }) => {
        const key = `part ${element}`;
        setQuery("");
        // A part that was made a moment ago is not drawn yet.
        const now = partsOf(useStudio.getState().catalogue, robot);
        setFolded((before) => ({ ...before, ...unfoldedFor(now, element) }));
        setAt(key);
        // The row is there once the palette is drawn with it.
        requestAnimationFrame(() => {
          const found = tree.current?.querySelector<HTMLElement>(`[data-row="${CSS.escape(key)}"]`);
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
    if (next !== undefined) tree.current?.querySelector<HTMLElement>(`[data-row="${CSS.escape(next.key)}"]`)?.focus();
  });

  const go = (row: Row | undefined) => {
    if (row === undefined) return;
    setAt(row.key);
    tree.current?.querySelector<HTMLElement>(`[data-row="${CSS.escape(row.key)}"]`)?.focus();
  };
  const fold = (row: Row, open: boolean) => {
    setFolded((before) => ({ ...before, [row.key]: !open }));
  };

  const onKeyDown = (event: KeyboardEvent) => {
    const index = items.findIndex((row) => row.key === current);
    const row = items[index];
    if (row === undefined) return;
    const [inwards, outwards] = mirrored() ? ["ArrowLeft", "ArrowRight"] : ["ArrowRight", "ArrowLeft"];
    const above = items.slice(0, index).findLast((one) => one.kind === "fold" && one.level < row.level);
    if (event.key === "ArrowDown") go(items[index + 1]);
    else if (event.key === "ArrowUp") go(items[index - 1]);
    else if (event.key === "Home") go(items[0]);
    else if (event.key === "End") go(items.at(-1));
    else if (event.key === inwards && row.kind === "fold") {
      if (row.open) go(items[index + 1]);
      else fold(row, true);
    } else if (event.key === outwards && row.kind === "fold" && row.open) fold(row, false);
    else if (event.key === outwards) go(above);
    else if (event.key === "/") find.current?.focus();
    else if (
      row.kind === "fold" &&
      row.object?.category === "variable" &&
      variableKey(event, { robot, name: row.object.name }, () => document.activeElement?.getBoundingClientRect())
    )
      event.stopPropagation();
    else if (row.kind === "part" && isOwn(row.shape) && ownKey(event, row.shape.element)) event.stopPropagation();
    else if (event.key === "Enter" || event.key === " ") {
      if (row.kind === "fold") fold(row, !row.open);
      else if (row.kind === "new") newVariable();
      else addPart(row.shape.element);
    } else return;
    event.preventDefault();
  };

  return (
    <div className="palette">
      <RobotButton />
      <label className="palette-find row muted rigid">
        <Icon name="search" />
        <input
          ref={find}
          type="search"
          aria-label={t("parts.find")}
          placeholder={t("parts.find")}
          data-testid="part-find"
          value={query}
          onChange={(event) => {
            setQuery(event.target.value);
          }}
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
      {rows.length === 0 ? <p className="palette-none muted">{t("parts.none", { query })}</p> : null}
      <div
        ref={tree}
        role="tree"
        aria-label={t("parts.tree")}
        onKeyDown={onKeyDown}
        onBlur={(event) => {
          // A row that goes with its part takes the focus along; that is no leaving.
          if (event.relatedTarget !== null || event.target.isConnected) focused.current = null;
        }}
      >
        {rows.map((row) =>
          row.kind === "heading" ? (
            <div key={row.key} className="palette-heading muted" role="presentation">
              {row.label}
            </div>
          ) : (
            <RowView
              key={row.key}
              row={row}
              robot={robot}
              focused={row.key === current}
              onFocus={() => {
                setAt(row.key);
                focused.current = { key: row.key, index: items.findIndex((one) => one.key === row.key) };
              }}
              onFold={() => {
                if (row.kind === "fold") fold(row, !row.open);
              }}
              onNamed={(name) => {
                const key = `object variable ${name}`;
                setAt(key);
                requestAnimationFrame(() => {
                  tree.current?.querySelector<HTMLElement>(`[data-row="${CSS.escape(key)}"]`)?.focus();
                });
              }}
            />
          ),
        )}
      </div>
      {form === null ? null : <VariableForm key={`${form.robot} ${form.was}`} {...form} />}
      <VariableMenu />
    </div>
  );
}

interface RowProps {
  row: Exclude<Row, { kind: "heading" }>;
  robot: string;
  focused: boolean;
  onFocus: () => void;
  onFold: () => void;
  /** A variable's name was typed over, or stays as it is. */
  onNamed: (name: string) => void;
}

function RowView({ row, robot, focused, onFocus, onFold, onNamed }: RowProps) {
  const renaming = useVariables((state) => state.renaming);
  const common = {
    role: "treeitem",
    "aria-level": row.level,
    "data-row": row.key,
    "data-level": row.level,
    tabIndex: focused ? 0 : -1,
    onFocus,
  };
  if (row.kind === "new") {
    return (
      <div
        {...common}
        className="palette-part palette-new row muted"
        data-testid="new-variable"
        onClick={() => newVariable()}
      >
        <Icon name="plus" size={16} />
        <span className="palette-name">{row.label}</span>
      </div>
    );
  }
  if (row.kind === "fold") {
    const variable = row.object?.category === "variable" ? { robot, name: row.object.name } : null;
    return (
      <div
        {...common}
        {...(variable === null ? {} : { ...variableHandlers(variable), "data-removable": true })}
        className="palette-fold row"
        aria-expanded={row.open}
        data-testid={`fold-${row.label}`}
        onClick={onFold}
      >
        <Icon name={row.open ? "chevron-down" : "chevron-right"} size={14} />
        {row.object === null ? null : <Tile icon={iconOf(row.object)} colour={colourOf(row.object)} size={22} />}
        {variable !== null && renaming?.name === variable.name && renaming.robot === robot ? (
          <VariableName of={variable} done={onNamed} />
        ) : (
          <span className="palette-name">{row.label}</span>
        )}
        {row.aside === "" ? null : <span className="palette-aside ellipsis muted">{row.aside}</span>}
        {row.object === null ? null : <Live object={row.object} />}
      </div>
    );
  }
  const { shape } = row;
  const icon = shape.method === null ? shape.icon : shape.method.icon || shape.icon;
  return (
    <div
      {...common}
      className="palette-part row"
      data-testid={`part-${shape.element}`}
      title={text(shape.help)}
      {...(isOwn(shape) ? { ...ownHandlers(shape.element), "data-removable": true } : {})}
      onPointerDown={(event) => {
        beginDrag(event, { kind: "part", element: shape.element });
        if (isOwn(shape)) restOnOwn(event, shape.element);
      }}
      onClick={() => {
        if (!justDragged()) addPart(shape.element);
      }}
    >
      <Tile icon={icon} colour={shape.colour} size={22} />
      <span className="palette-name">{row.label}</span>
      {row.aside === "" ? null : <span className="palette-aside ellipsis muted">{row.aside}</span>}
      {isOwn(shape) ? <CustomBlockMore name={shape.element} /> : null}
    </div>
  );
}

/** A variable of the mission has no icon of its own. */
function iconOf({ icon, category, type }: RobotObject): string {
  return icon !== "" || category !== "variable" ? icon : type === "boolean" ? "toggle-right" : "hash";
}

function colourOf({ category }: RobotObject): "action" | "test" {
  return category === "actuator" ? "action" : "test";
}

/** What a sensor or variable of the watched agent says now, while a run exists. */
function Live({ object }: { object: RobotObject }) {
  const program = useStudio((state) => state.activeProgram);
  const value = useRun((state) => {
    if (object.category === "actuator") return undefined;
    const agent = watchedAgent(state, program);
    return object.category === "sensor" ? agent?.inputs[object.name] : agent?.values[object.name];
  });
  if (value === undefined) return null;
  return <span className="palette-live rigid">{valueWords(object, value)}</span>;
}
