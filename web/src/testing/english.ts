/** Before each file of tests: the page speaks English, as it does before anything is drawn. */
import { speak } from "../i18n/words";

await speak("en");
