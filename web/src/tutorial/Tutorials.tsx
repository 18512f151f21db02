/** The room's door: what the shell puts above the graph. */
import { useEffect } from "react";

import { keepTutorials } from "./opening";
import { TutorialPanel } from "./Panel";
import { keepWatching } from "./watching";
import { Welcome } from "./Welcome";

export function Tutorials() {
  useEffect(() => {
    const offOpening = keepTutorials();
    const offWatching = keepWatching();
    return () => {
      offOpening();
      offWatching();
    };
  }, []);
  return (
    <>
      <TutorialPanel />
      <Welcome />
    </>
  );
}
