/** Before each file of tests: the page speaks English, as it does before anything is drawn, and shows every detail. */
import { speak } from "../i18n/words";

localStorage.setItem("kitrobot.simple", "no");
await speak("en");
