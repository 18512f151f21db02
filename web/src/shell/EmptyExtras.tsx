/** Under an empty program: tutorials and examples; fetched when there is one. */
import { TutorialCards } from "../tutorial/Cards";
import { useTutorial } from "../tutorial/state";
import { useDocument } from "./document";
import { Examples } from "./Examples";

/** Who follows a tutorial has been told what to do, and the sheet of all missions has the same. */
export function EmptyExtras() {
  const learning = useTutorial(({ tutorial }) => tutorial !== null);
  const choosing = useDocument((document) => document.overlay === "open");
  if (learning || choosing) return null;
  return (
    <>
      <TutorialCards brief />
      <Examples />
    </>
  );
}
