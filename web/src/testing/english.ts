/** Before each file of tests: the page speaks English, as it does before anything is drawn. */
import { speak } from "../words/words";

await speak("en");
