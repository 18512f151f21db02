/** Above the graph: the panel of the tutorial that is open, and the welcome. */
import { useEffect } from "react";

import { complain } from "../../session/document";
import { later } from "../../ui/later";
import { keepTutorials } from "./opening";
import { useTutorial } from "./state";
import { Welcome } from "./Welcome";

const TutorialPanel = later(() => import("./Panel").then((chunk) => chunk.TutorialPanel), complain);

export function Tutorials() {
  const open = useTutorial((state) => state.tutorial !== null);
  useEffect(keepTutorials, []);
  return (
    <>
      {open ? <TutorialPanel /> : null}
      <Welcome />
    </>
  );
}
