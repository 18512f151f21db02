/** Before each file of tests: the page speaks English, as it does before anything is drawn, and a mouse points at it. */
import { speak } from "../i18n/words";

// jsdom has none.
globalThis.matchMedia ??= ((media: string) => ({ ...new EventTarget(), media, matches: false })) as typeof matchMedia;

await speak("en");
