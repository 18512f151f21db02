/**
 * What robots are built of: the kits beside a mission, the question which one it is, and what waits for its answer.
 *
 * It is asked before a program first goes to a robot, when it was said neither of this robot nor of another one; the answer
 * is remembered for it and for the next one. Left to others: the cards (`KitSheet`).
 */
import { useEffect } from "react";
import { create } from "zustand";

import type { KitEntry } from "../../api/generated";
import { partsApi } from "../../api/parts";
import { knowsKit, setKit, useBoards } from "./boards";

const useKits = create<{ path: string | null; kits: readonly KitEntry[] | null }>(() => ({ path: null, kits: null }));

/** Asks for the kits beside a mission, once for each; null before they are known, none where they cannot be had. */
export function useKitsAt(path: string): readonly KitEntry[] | null {
  const { kits } = useKits();
  useEffect(() => {
    if (useKits.getState().path === path) return;
    useKits.setState({ path });
    partsApi.kits(path).then(
      (found) => {
        if (useKits.getState().path === path) useKits.setState({ kits: found });
      },
      // The robot is then taken as its own file says; the next time that the panel opens it is asked again.
      () => useKits.setState({ path: null, kits: [] }),
    );
  }, [path]);
  return kits;
}

/** What is known of a kit; null for the robot's own file, and before the kits are known. */
export function knownKit(name: string): KitEntry | null {
  return useKits.getState().kits?.find((kit) => kit.name === name) ?? null;
}

interface Asking {
  /** The robot that it is asked of. */
  address: string;
  /** What goes on once it is answered. */
  waiting: readonly (() => void)[];
}

export const useKitQuestion = create<{ asking: Asking | null }>(() => ({ asking: null }));

/** Does it at once where it is known what the robot is built of, else after that was answered. */
export function withKit(address: string, go: () => void): void {
  if (knowsKit(useBoards.getState(), address)) go();
  else askKit(address, go);
}

/** Asks what the robot there is built of, although it may be known. */
export function askKit(address: string, ...then: readonly (() => void)[]): void {
  useKitQuestion.setState(({ asking }) => ({
    asking: { address: asking?.address ?? address, waiting: [...(asking?.waiting ?? []), ...then] },
  }));
}

/** Nothing is sent that waited for the answer. */
export function dropKitQuestion(): void {
  useKitQuestion.setState({ asking: null });
}

/** The answer; the next robot is taken for one of the same kit. What waited goes on. */
export function chooseKit(address: string, kit: string): void {
  setKit(address, kit);
  const { asking } = useKitQuestion.getState();
  dropKitQuestion();
  for (const go of asking?.waiting ?? []) go();
}
