/** Which robots stand out in the arena: whose menu is open, who is followed, whose program is looked at; and what the menu does. */
import { create } from "zustand";

import type { Harm } from "../../api/wire";
import { t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { useRun } from "../../session/run";

interface RobotsState {
  /** The open menu, at a place of the window. */
  menu: { name: string; x: number; y: number } | null;
  /** The robot that the camera follows; "" for none. */
  followed: string;
  /** Robots of this program stand out; "" for all alike. */
  program: string;
  /** Announcements for screen readers: the chosen robot, faults. */
  said: string;
}

export const useRobots = create<RobotsState>(() => ({ menu: null, followed: "", program: "", said: "" }));

/** Opens the program of a robot and watches that robot. */
export function choose({ name, program }: { name: string; program: string }): void {
  useStudio.getState().setActiveProgram(program);
  useRun.getState().selectAgent(name, program);
  announce(t("arena.chosen", { name }));
}

export function openRobotMenu(name: string, x: number, y: number): void {
  useRobots.setState({ menu: { name, x, y } });
}

export function closeRobotMenu(): void {
  useRobots.setState({ menu: null });
}

/** For screen readers. */
export function announce(said: string): void {
  useRobots.setState({ said });
}

/** Robots of that program stand out; "" for all alike. */
export function highlightProgram(program: string): void {
  useRobots.setState({ program });
}

export function stopFollowing(): void {
  useRobots.setState({ followed: "" });
}

export function injectFault(name: string, kind: Harm): void {
  useRun.getState().injectFault(name, kind);
}

/** Keeps a robot in the middle of the arena, or lets it go when it is there already. */
export function follow(name: string): void {
  useRobots.setState(({ followed }) => ({ followed: followed === name ? "" : name }));
}
