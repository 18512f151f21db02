/** A choice between two, in a frame with its question. */
import { type ReactNode, useId } from "react";

import { Checkbox } from "./Checkbox";

interface RadioPairProps {
  legend: ReactNode;
  /** What is said where the second one is not chosen, and where it is. */
  words: readonly [string, string];
  testIds: readonly [string, string];
  second: boolean;
  choose: (second: boolean) => void;
}

export function RadioPair({ legend, words, testIds, second, choose }: RadioPairProps) {
  const name = useId();
  return (
    <fieldset className="sheet-choice boxed">
      <legend>{legend}</legend>
      {([0, 1] as const).map((at) => (
        <Checkbox
          key={at}
          type="radio"
          name={name}
          checked={second === (at === 1)}
          testId={testIds[at]}
          set={() => choose(at === 1)}
        >
          {words[at]}
        </Checkbox>
      ))}
    </fieldset>
  );
}
