/** A study as it is: its picture, the runs of the chosen point, its numbers as a table, and what can be done with it. */
import { type ReactNode, useRef, useState } from "react";

import type { Study } from "../../api/generated";
import { decimal, grouped } from "../../i18n/numbers";
import { t } from "../../i18n/words";
import { Button } from "../../ui/Button";
import { download } from "../../ui/download";
import { Select } from "../../ui/Select";
import { svgFileOf } from "../../ui/svg-file";
import { pictureOf, variedAxes } from "./chart";
import { Command } from "./Command";
import { Curve } from "./Curve";
import { measureWords } from "./figures";
import { ResultTable } from "./ResultTable";
import { RunStrip } from "./RunStrip";
import { StudyMaps } from "./StudyMaps";
import { downloadTable, openStudy, resume, useStudy } from "./study-work";

/** `children` stand behind what can be done with it. */
export function Results({ study, children }: { study: Study; children: ReactNode }) {
  const busy = useStudy((state) => state.busy !== null);
  const [wanted, setMeasure] = useState("");
  const measure = Math.max(0, study.measures.indexOf(wanted));
  const picture = useRef<HTMLDivElement>(null);
  const hasCurve = ["curve", "scatter"].includes(pictureOf(study));
  const savePicture = () => {
    const curve = picture.current?.querySelector("svg");
    if (curve instanceof SVGSVGElement) download(`${study.study}.svg`, svgFileOf(curve), "image/svg+xml");
  };
  return (
    <>
      <div className="row wrap experiment-head">
        <Studies study={study} />
        <Select
          label={t("experiment.measure")}
          testId="experiment-measure"
          value={study.measures[measure] ?? ""}
          options={study.measures.map((name) => [name, measureWords(name)] as const)}
          keep={setMeasure}
        />
        {busy ? null : (
          <span className="muted" data-testid="experiment-done">
            {t("experiment.progress", { done: grouped(study.done), total: grouped(study.total) })}
          </span>
        )}
        {study.done < study.total && !busy ? (
          <Button icon="play" testId="experiment-resume" onClick={resume}>
            {t("experiment.resume")}
          </Button>
        ) : null}
        {children}
      </div>
      {study.done === 0 ? (
        <p className="prose muted">{t("experiment.no-runs")}</p>
      ) : (
        <>
          <div ref={picture}>
            <StudyPicture study={study} measure={measure} />
          </div>
          <RunStrip study={study} measure={measure} />
          <ResultTable study={study} />
          <div className="row">
            <Button icon="download" testId="experiment-csv" onClick={() => void downloadTable()}>
              {t("experiment.csv")}
            </Button>
            {hasCurve ? (
              <Button icon="download" testId="experiment-svg" onClick={savePicture}>
                {t("experiment.svg")}
              </Button>
            ) : null}
          </div>
        </>
      )}
      <Command text={study.command} />
    </>
  );
}

function Studies({ study }: { study: Study }) {
  const path = useStudy((state) => state.path);
  const studies = useStudy((state) => state.choices?.studies);
  const names = studies?.map((one) => one.study) ?? [];
  if (names.length < 2) return <strong dir="auto">{study.study}</strong>;
  return (
    <Select
      label={t("experiment.study", { path })}
      testId="experiment-study"
      value={study.study}
      options={names}
      wrong={false}
      keep={(name) => void openStudy(name)}
    />
  );
}

function StudyPicture({ study, measure }: { study: Study; measure: number }) {
  const varied = variedAxes(study);
  const picture = pictureOf(study);
  const [wanted, setAxis] = useState("");
  const found = study.axes.findIndex(({ address }) => address === wanted);
  if (picture === "dots") return null;
  if (picture === "map" || picture === "maps") return <StudyMaps study={study} measure={measure} />;
  const axis = varied.includes(found) ? found : (varied[0] ?? 0);
  return (
    <>
      {picture === "scatter" ? (
        <Select
          label={t("experiment.over")}
          testId="experiment-over"
          value={study.axes[axis]?.address ?? ""}
          options={varied.flatMap((at) => study.axes[at]?.address ?? [])}
          keep={setAxis}
        />
      ) : null}
      <Curve study={study} axis={axis} measure={measure} joined={picture === "curve"} />
      <p className="prose muted small-text">
        {t("experiment.curve-says", { confidence: decimal(100 * study.confidence) })}
      </p>
    </>
  );
}
