/** What happened in the step that led to a scene. */
import type { Scene } from "../../api/generated";
import { Said } from "../../i18n/Said";
import type { ModelRun } from "./table";

export function SceneEvents({ run, scene }: { run: ModelRun; scene: Scene }) {
  return (
    <p className="muted small-text">
      {run.events
        .filter(({ step }) => step === scene.step - 1)
        .map(({ text }, index) => (
          <span key={index}>
            <Said text={text} />{" "}
          </span>
        ))}
    </p>
  );
}
