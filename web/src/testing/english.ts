/** Before each file of tests: the page speaks English and shows every detail, and a mouse points at it. */
import { speak } from "../i18n/words";

// jsdom has none.
globalThis.matchMedia ??= ((media: string) => ({ ...new EventTarget(), media, matches: false })) as typeof matchMedia;

localStorage.setItem("kitrobot.simple", "no");
await speak("en");
