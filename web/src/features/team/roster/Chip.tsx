/** A robot, a role or a group as a chip: dragged, or moved from its menu, which Enter opens. */
import { type KeyboardEvent, type PointerEvent as ReactPointerEvent, useRef, useState } from "react";
import { createPortal } from "react-dom";
import { create } from "zustand";

import { StateShape } from "../../../components/StateShape";
import { t } from "../../../i18n/words";
import { useStudio } from "../../../model/studio";
import { isLive, useRun } from "../../../session/run";
import { Tile } from "../../../theme";
import { FloatingMenu } from "../../../ui/FloatingMenu";
import { followPointer } from "../../../ui/pointer-drag";
import { type Goal, goalKey, placesOf, put, type Thing, whyNot } from "./roster-moves";

interface Dragged {
  thing: Thing | null;
  at: { x: number; y: number };
  goal: Goal | null;
}

export const useDragged = create<Dragged>(() => ({ thing: null, at: { x: 0, y: 0 }, goal: null }));

/** The place under a point of the window. */
function goalAt(x: number, y: number): Goal | null {
  const place = document.elementFromPoint(x, y)?.closest<HTMLElement>("[data-goal]");
  const { goal, name } = place?.dataset ?? {};
  if (goal !== "role" && goal !== "group" && goal !== "spare") return null;
  return { kind: goal, name: name ?? "" };
}

/** Follows a pointer that went down on a chip; `moved` is called while it drags. */
function drag(event: ReactPointerEvent, thing: Thing, moved: () => void): void {
  followPointer(event, {
    move: (at) => {
      moved();
      useDragged.setState({ thing, at, goal: goalAt(at.x, at.y) });
    },
    drop: (at) => {
      const goal = goalAt(at.x, at.y);
      useDragged.setState({ thing: null, goal: null });
      if (goal !== null) put(thing, goal);
    },
    end: () => useDragged.setState({ thing: null, goal: null }),
  });
}

/** What follows the pointer. */
export function DragGhost() {
  const { thing, at } = useDragged();
  if (thing === null) return null;
  return createPortal(
    <div
      className="member-ghost small-text carried"
      style={{ transform: `translate(${String(at.x + 10)}px, ${String(at.y + 12)}px)` }}
    >
      <strong>{thing.name}</strong>
    </div>,
    document.body,
  );
}

/** What a place does about what is dragged over it: whether it takes it, and why not. */
export function useOver(goal: Goal): { over: boolean; why: string } {
  const thing = useDragged((state) =>
    state.goal !== null && goalKey(state.goal) === goalKey(goal) ? state.thing : null,
  );
  const mission = useStudio((studio) => studio.mission);
  return { over: thing !== null, why: thing === null ? "" : whyNot(mission, thing, goal) };
}

interface ChipProps {
  thing: Thing;
  /** Where it is, as it is spoken. */
  places: string;
}

export function Chip({ thing, places }: ChipProps) {
  const [menu, setMenu] = useState<{ x: number; y: number } | null>(null);
  const button = useRef<HTMLButtonElement>(null);
  const dragged = useRef(false);
  const state = useRun((run) => {
    const agent = thing.isAgent ? run.agents.find((one) => one.name === thing.name) : undefined;
    const shown = agent?.state ?? "idle";
    return isLive(run.status) || shown === "failed" || shown === "stalled" ? shown : "idle";
  });
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key !== "Delete" && event.key !== "Backspace") return;
    event.preventDefault();
    put(thing, { kind: "spare", name: "" });
  };
  const { name } = thing;
  return (
    <>
      <button
        type="button"
        className="member-chip finger row small-text slim gap-s hover"
        ref={button}
        data-testid={`chip-${thing.from === undefined ? "" : `${thing.from}-`}${name}`}
        data-state={state}
        title={name}
        aria-label={t("roster.chip", { name, places })}
        aria-haspopup="menu"
        aria-expanded={menu !== null}
        onPointerDown={(event) => {
          dragged.current = false;
          drag(event, thing, () => {
            dragged.current = true;
          });
        }}
        onClick={(event) => {
          if (dragged.current) return;
          const box = event.currentTarget.getBoundingClientRect();
          setMenu({ x: box.left, y: box.bottom + 4 });
        }}
        onContextMenu={(event) => {
          event.preventDefault();
          setMenu({ x: event.clientX, y: event.clientY });
        }}
        onKeyDown={onKeyDown}
      >
        {thing.isAgent ? <StateShape state={state} /> : <Tile icon="users" colour="team" size={14} />}
        <span dir="auto">{name}</span>
      </button>
      {menu === null ? null : (
        <FloatingMenu
          id="chip"
          label={t("roster.place", { name })}
          at={menu}
          entries={placesOf(thing)}
          onLeave={() => setMenu(null)}
          onClose={() => {
            setMenu(null);
            button.current?.focus();
            // The chip may have gone to another place, with its focus.
            requestAnimationFrame(() => {
              if (document.activeElement !== document.body) return;
              document.querySelector<HTMLElement>(`[data-testid="chip-${CSS.escape(name)}"]`)?.focus();
            });
          }}
        />
      )}
    </>
  );
}
