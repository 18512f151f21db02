/** The room's door: what the shell puts above the graph. */
import { useEffect } from "react";

import { complain } from "../shell/document";
import { later } from "../shell/later";
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
