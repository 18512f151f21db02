/** The sheet that is printed: what the mission is, its team, and of each program its graph and its text. */
import { GraphDrawing, MARGIN } from "../../../components/graph/GraphDrawing";
import { t } from "../../../i18n/words";
import { type StudioState } from "../../../model/studio";
import { text } from "../../../model/texts";
import type { Program } from "../../../model/types";
import { drawProgram } from "../../../session/drawing";
import type { PrintChoice } from "../choice";
import { type Paper, partsOf, wholePage } from "./cuts";

/** What A4 and Letter both have inside of margins of 15 mm, with a line for what the part is called. */
const PAPER: Paper = { width: 680, height: 910, heading: 64, largest: 0.8, smallest: 0.4 };
/** The same sheets turned, for a graph that is wider than high and shown whole. */
const LANDSCAPE: Paper = { ...PAPER, width: 940, height: 640 };
/** A text that is not longer stays on one page. */
const LINES_OF_A_PAGE = 50;

function Team({ state: { mission, catalogue } }: { state: StudioState }) {
  if (mission.agents.length === 0) return null;
  const robotOf = (program: string) => mission.programs.find((one) => one.name === program)?.robot ?? "";
  const labelOf = (robot: string) => {
    const found = catalogue.robots.find((one) => one.name === robot);
    return found === undefined ? robot : text(found.label, robot);
  };
  return (
    <section>
      <h2>{t("sheet.team")}</h2>
      <table>
        <thead>
          <tr>
            {(["sheet.agent", "sheet.program", "sheet.robot", "sheet.start"] as const).map((key) => (
              <th key={key} scope="col">
                {t(key)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {mission.agents.map(({ name, program, start }) => (
            <tr key={name}>
              <td>
                <bdi>{name}</bdi>
              </td>
              <td>
                <bdi>{program}</bdi>
              </td>
              <td>
                <bdi>{labelOf(robotOf(program))}</bdi>
              </td>
              <td>
                <bdi>{start || name}</bdi>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

function ProgramPages({ program, state, fit }: { program: Program; state: StudioState; fit: boolean }) {
  const { layout: all } = drawProgram(state, program);
  const whole = fit ? wholePage(all, [PAPER, LANDSCAPE], MARGIN) : null;
  const parts = whole === null ? partsOf(all, PAPER, MARGIN) : [{ layout: all, width: whole.width }];
  const code = state.report?.programs.find((one) => one.name === program.name)?.lll ?? "";
  const { name } = program;
  return (
    <section className="sheet-program">
      <div className={whole?.paper === LANDSCAPE ? "sheet-landscape" : ""}>
        <h2>
          <bdi>{name}</bdi>
        </h2>
        {parts.map(({ layout, width }, index) => (
          <figure key={index} className="sheet-part" aria-label={t("sheet.graph", { name })}>
            {parts.length > 1 ? (
              <figcaption>{t("sheet.part", { name, number: index + 1, total: parts.length })}</figcaption>
            ) : null}
            <div style={{ width }}>
              <GraphDrawing layout={layout} title={name} inside="" />
            </div>
          </figure>
        ))}
      </div>
      <h3>{t("code.lll")}</h3>
      {code === "" ? (
        <p>{t("sheet.no-code")}</p>
      ) : (
        <pre dir="ltr" className={code.split("\n").length > LINES_OF_A_PAGE ? "" : "sheet-whole"}>
          {code}
        </pre>
      )}
    </section>
  );
}

/** `title` is that of the mission, or its file's name. */
export function PrintSheet(props: { state: StudioState; choice: PrintChoice; title: string; file: string }) {
  const { state, choice, title, file } = props;
  const { mission, world, activeProgram } = state;
  const programs = mission.programs.filter(({ name }) => !choice.one || name === activeProgram);
  const help = text(mission.help ?? {});
  return (
    <article>
      <header>
        <h1>{title}</h1>
        <p className="sheet-file">
          <bdi>{file}</bdi>
          {world === null ? null : ` · ${t("sheet.world", { name: world.name })}`}
        </p>
        {help === "" ? null : <p>{help}</p>}
      </header>
      {choice.one ? null : <Team state={state} />}
      {programs.map((program) => (
        <ProgramPages key={program.name} program={program} state={state} fit={choice.fit} />
      ))}
    </article>
  );
}
