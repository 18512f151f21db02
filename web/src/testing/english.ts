/**
 * Before each file of tests: the page begins anew, speaks English and shows every detail, and a mouse points at it. After
 * it, what the page still fetches is waited for: the worker may end with this file.
 */
import { afterAll, vi } from "vitest";

import { speak } from "../i18n/words";
import { resetStores } from "./zustand";

// jsdom has none.
globalThis.matchMedia ??= ((media: string) => ({ ...new EventTarget(), media, matches: false })) as typeof matchMedia;

localStorage.clear();
localStorage.setItem("kitrobot.simple", "no");
resetStores();
await speak("en");

afterAll(() => vi.dynamicImportSettled());
