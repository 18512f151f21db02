/** What is different between the open mission and its file, in words; and both merged, with a choice where both changed the same. */
import { useCallback, useRef, useState } from "react";

import type { Conflicted, Merged } from "../api/generated";
import { journalApi } from "../api/journal";
import { whyRefused } from "../api/refusal";
import { Said } from "../i18n/Said";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import type { Mission } from "../model/types";
import { closeOverlay, dismissBanner, question, reportError, show } from "../session/document";
import { commonBase, keepMerge, revisionMerged } from "../session/merges";
import { type PartDifference, partDifference } from "../session/saving";
import { Button } from "../ui/Button";
import { RadioPair } from "../ui/RadioPair";
import { Sheet } from "../ui/Sheet";
import { useFetched } from "../ui/use-fetched";

/** What was asked to be merged: a later edit is not in it. */
interface MergeRequest {
  base: Mission;
  mission: Mission;
}

function apply({ revision, mission, theirs }: Merged, asked: MergeRequest): void {
  const studio = useStudio.getState();
  if (studio.mission !== asked.mission) {
    // It was edited meanwhile: what was merged is not what there is now.
    show("difference");
    return;
  }
  const from = revisionMerged();
  studio.execute({ label: t("merge.step"), execute: () => mission });
  keepMerge(mission, { from, to: revision, theirs });
  show(null);
  dismissBanner();
  question(t("merge.done"), [], "note", t("merge.done-help"));
}

interface ConflictProps {
  conflict: Conflicted;
  choose: (theirs: boolean) => void;
}

function Conflict({ conflict: { what, sentence, ours, theirs, taken, open }, choose }: ConflictProps) {
  if (!open)
    return (
      <li>
        <Said text={sentence} />
      </li>
    );
  return (
    <li>
      <RadioPair
        legend={<Said text={what} />}
        words={[
          ours === "" ? t("merge.yours") : t("merge.yours-is", { value: ours }),
          theirs === "" ? t("merge.theirs") : t("merge.theirs-is", { value: theirs }),
        ]}
        testIds={["merge-yours", "merge-theirs"]}
        second={taken}
        choose={choose}
      />
    </li>
  );
}

export function DifferenceSheet() {
  const part = partDifference();
  return part === null ? <MissionDifference /> : <PartSheet {...part} />;
}

function PartSheet({ file, changes }: PartDifference) {
  return (
    <Sheet title={t("difference.part-title", { file })} testId="difference-dialog" wide onClose={closeOverlay}>
      <p>{t("difference.part-intro")}</p>
      <ul data-testid="differences">
        {changes.map((change) => (
          <li key={change}>
            <Said text={change} />
          </li>
        ))}
      </ul>
    </Sheet>
  );
}

function MissionDifference() {
  const ask = useCallback(() => {
    const { file, mission } = useStudio.getState();
    return journalApi.difference(file.path, mission).then((found) => found.changes);
  }, []);
  const changes = useFetched(ask, (cause) => [whyRefused(cause).message]);
  const [merging, setMerging] = useState<{ asked: MergeRequest; merged: Merged; waits: boolean } | null>(null);
  /** Which request is the last one: an answer to an earlier choice is too late. */
  const last = useRef(0);

  const merge = (asked: MergeRequest, taken: readonly string[], first: boolean) => {
    const number = ++last.current;
    journalApi.merge(useStudio.getState().file.path, asked.base, asked.mission, taken).then((merged) => {
      if (number !== last.current) return;
      if (first && merged.conflicts.length === 0) apply(merged, asked);
      else setMerging({ asked, merged, waits: false });
    }, reportError);
  };

  if (merging !== null) {
    const { asked, merged, waits } = merging;
    const taken = merged.conflicts.filter((one) => one.taken).map(({ name }) => name);
    return (
      <Sheet title={t("merge.title")} testId="merge-dialog" wide onClose={closeOverlay}>
        <p>{t("merge.intro")}</p>
        <ul data-testid="conflicts">
          {merged.conflicts.map((conflict) => (
            <Conflict
              key={conflict.name}
              conflict={conflict}
              choose={(theirs) => {
                const others = taken.filter((name) => name !== conflict.name);
                const conflicts = merged.conflicts.map((one) =>
                  one.name === conflict.name ? { ...one, taken: theirs } : one,
                );
                setMerging({ asked, merged: { ...merged, conflicts }, waits: true });
                merge(asked, theirs ? [...others, conflict.name] : others, false);
              }}
            />
          ))}
        </ul>
        <div className="sheet-foot flex gap-m justify-end">
          <Button onClick={closeOverlay}>{t("open.cancel")}</Button>
          <Button
            ink

            testId="merge-apply"
            disabled={waits}
            onClick={() => apply(merged, asked)}
          >
            {t("merge.apply")}
          </Button>
        </div>
      </Sheet>
    );
  }
  const base = commonBase();
  return (
    <Sheet title={t("difference.title")} testId="difference-dialog" wide onClose={closeOverlay}>
      {changes === null ? (
        <p>{t("open.loading")}</p>
      ) : changes.length === 0 ? (
        <p>{t("difference.none")}</p>
      ) : (
        <>
          <p>{t("difference.intro")}</p>
          <ul data-testid="differences">
            {changes.map((change, at) => (
              <li key={at}>
                <Said text={change} />
              </li>
            ))}
          </ul>
          {base === null ? (
            <p className="sheet-note muted small-text">{t("merge.no-base")}</p>
          ) : (
            <div className="sheet-foot flex gap-m justify-end">
              <Button testId="merge" onClick={() => merge({ base, mission: useStudio.getState().mission }, [], true)}>
                {t("merge.merge")}
              </Button>
            </div>
          )}
        </>
      )}
    </Sheet>
  );
}
