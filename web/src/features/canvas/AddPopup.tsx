/** Type-to-add: press `/`, type three letters, Enter. Opens beside the selection, or on an empty slot for what fits it. */
import { useEffect, useMemo, useRef, useState } from "react";

import { t } from "../../i18n/words";
import { wraps } from "../../model/commands/wrapParts";
import { rank } from "../../model/part-search";
import { fits, type Shape, title } from "../../model/parts";
import { text } from "../../model/texts";
import type { Drawing } from "../../session/drawing";
import { addPart, addPartAt, wrapSelection } from "../../session/edits";
import { newVariable } from "../../session/variables";
import { type Adding, useView } from "../../session/view";
import { Icon, Tile } from "../../theme";
import { anchorOf } from "./viewport";

const WIDTH = 288;
const MOST = 40;

/** For a test, what a robot feels comes before what puts tests together. */
function order(shape: Shape, forSlot: boolean): number {
  return forSlot && shape.object === null ? 1 : 0;
}

export function candidates({ parts, program }: Drawing, { slot, wrap }: Adding, query: string): Shape[] {
  const owner = parts.shape(program.vertices.find((one) => one.id === slot?.vertex)?.element ?? "");
  const plug = owner.plugs.find((one) => one.name === slot?.slot);
  const ranked = parts.all.flatMap((shape) => {
    if (plug !== undefined && !fits(shape, plug)) return [];
    if (wrap === true && !wraps(shape)) return [];
    const at = rank(shape, query);
    return at === null ? [] : [{ shape, at: at + order(shape, plug !== undefined) / 2 }];
  });
  return ranked
    .sort((a, b) => a.at - b.at)
    .slice(0, MOST)
    .map(({ shape }) => shape);
}

export function AddPopup({ adding, drawing }: { adding: Adding; drawing: Drawing }) {
  const [query, setQuery] = useState("");
  const [at, setAt] = useState(0);
  const input = useRef<HTMLInputElement>(null);
  const list = useRef<HTMLUListElement>(null);
  const shapes = useMemo(() => candidates(drawing, adding, query), [drawing, adding, query]);
  const [anchor] = useState(() => anchorOf(adding.vertex, useView.getState().arc));

  useEffect(() => {
    input.current?.focus({ preventScroll: true });
  }, []);
  useEffect(() => {
    list.current?.children[at]?.scrollIntoView({ block: "nearest" });
  }, [at]);

  // Behind the parts: one that is not there yet.
  const fresh = adding.wrap !== true;
  const last = fresh ? shapes.length : shapes.length - 1;
  const make = () => {
    useView.getState().setAdding(null);
    newVariable(query.trim());
  };
  const label = t(adding.wrap === true ? "wrap.title" : "add.title");
  const close = () => {
    useView.getState().setAdding(null);
    useView.getState().viewport?.focus();
  };
  const add = (shape: Shape | undefined) => {
    if (shape === undefined) return;
    close();
    if (adding.wrap === true) wrapSelection(shape.element);
    else if (adding.slot === null) addPart(shape.element);
    else addPartAt(adding.slot, shape.element);
  };

  return (
    <div
      className="adding surface column"
      role="dialog"
      aria-label={label}
      style={
        {
          width: WIDTH,
          "--x": `${String(anchor?.x ?? 0)}px`,
          "--y": `${String(anchor?.y ?? 0)}px`,
        } as React.CSSProperties
      }
      onBlur={(event) => {
        if (!event.currentTarget.contains(event.relatedTarget)) useView.getState().setAdding(null);
      }}
      onKeyDown={(event) => {
        if (event.key === "ArrowDown") setAt(Math.min(at + 1, last));
        else if (event.key === "ArrowUp") setAt(Math.max(at - 1, 0));
        else if (event.key === "Enter" && fresh && at === shapes.length) make();
        else if (event.key === "Enter") add(shapes[at]);
        else if (event.key === "Escape") close();
        else return;
        event.preventDefault();
        event.stopPropagation();
      }}
    >
      <label className="adding-find row rigid muted">
        <Icon name="search" size={16} />
        <input
          ref={input}
          className="bare"
          type="text"
          role="combobox"
          aria-expanded="true"
          aria-controls="adding-list"
          aria-activedescendant={at > last ? undefined : `adding-${String(at)}`}
          aria-label={t("add.find")}
          placeholder={adding.wrap === true ? label : t("add.find")}
          data-testid="add-find"
          value={query}
          onChange={(event) => {
            setQuery(event.target.value);
            setAt(0);
          }}
        />
      </label>
      {shapes.length === 0 ? <p className="adding-none muted">{t("add.none")}</p> : null}
      {last < 0 ? null : (
        <ul ref={list} id="adding-list" role="listbox" aria-label={label}>
          {shapes.map((shape, index) => (
            <li
              key={shape.element}
              className="option"
              id={`adding-${String(index)}`}
              role="option"
              aria-selected={index === at}
              data-testid={`add-${shape.element}`}
              title={text(shape.help)}
              onPointerDown={(event) => event.preventDefault()}
              onPointerMove={() => {
                if (index !== at) setAt(index);
              }}
              onClick={() => add(shape)}
            >
              <Tile icon={shape.icon} colour={shape.colour} size={22} />
              {title(shape)}
            </li>
          ))}
          {fresh ? (
            <li
              className="option"
              id={`adding-${String(shapes.length)}`}
              role="option"
              aria-selected={at === shapes.length}
              data-testid="add-new-variable"
              onPointerDown={(event) => event.preventDefault()}
              onPointerMove={() => setAt(shapes.length)}
              onClick={make}
            >
              <Icon name="plus" size={22} />
              {t("variable.new-dots")}
            </li>
          ) : null}
        </ul>
      )}
    </div>
  );
}
