/** The work of the team: units that its robots share out among themselves. */
import { t } from "../../../i18n/words";
import { addWork, changeWork, worksOf } from "../../../model/commands/changeDeclared";
import { execute, useStudio } from "../../../model/studio";
import type { Work } from "../../../model/types";
import { Card, Count, freeDeclared, MOST } from "./parts";

/** More units than this are said in words only. */
const DRAWN = 24;
const NEW_UNITS = 12;

function WorkCard({ work, at }: { work: Work; at: number }) {
  const { name, units } = work;
  const lease = work.lease ?? null;
  const change = (what: Parameters<typeof changeWork>[2]) =>
    execute(changeWork(useStudio.getState().mission, at, what));
  return (
    <Card
      name={name}
      icon="package"
      work
      note={
        lease === null
          ? t("roster.units-said", { count: units })
          : t("roster.lease-said", { units: String(units), lease: String(lease) })
      }
      fields={
        <div className="roster-card-counts gap-s">
          <Count
            label={t("roster.units")}
            testId={`units-${name}`}
            value={units}
            min={0}
            max={MOST}
            keep={(wanted) => change({ units: wanted })}
          />
          <Count
            label={t("roster.lease")}
            title={t("roster.lease-help")}
            testId={`lease-${name}`}
            value={lease}
            min={0}
            max={MOST}
            optional
            keep={(wanted) => change({ lease: wanted })}
          />
        </div>
      }
    >
      {units > DRAWN ? null : (
        <div className="units wrap flex" aria-hidden="true">
          {Array.from({ length: units }, (_, unit) => (
            <span key={unit} />
          ))}
        </div>
      )}
    </Card>
  );
}

export function addedWork(): string | null {
  const { mission } = useStudio.getState();
  const name = freeDeclared(t("roster.new-work"));
  return execute(addWork(mission, name, NEW_UNITS)) ? name : null;
}

export function Works() {
  const works = worksOf(useStudio((studio) => studio.mission));
  return works.map((work, at) => <WorkCard key={at} work={work} at={at} />);
}
