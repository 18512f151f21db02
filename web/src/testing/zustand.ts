/**
 * In the place of zustand in tests, which share one page for many files: it knows every store that was made, so that
 * each file begins with all of them as the page begins.
 */
import { create as makeStore, useStore } from "zustand/react";
import type { StateCreator, StoreApi } from "zustand/vanilla";

const stores: Pick<StoreApi<unknown>, "setState" | "getInitialState">[] = [];

function makeKnownStore<T>(initializer: StateCreator<T>) {
  const store = makeStore(initializer);
  stores.push(store);
  return store;
}

export const create = makeKnownStore as unknown as typeof makeStore;
export { useStore };

/** Gives every store the state that it began with. */
export function resetStores(): void {
  for (const store of stores) store.setState(store.getInitialState(), true);
}
