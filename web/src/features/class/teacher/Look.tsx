/** One pupil, looked on: the graph as it was handed in last, goals and why not, and a few words to the pupil. */
import { type FormEvent, useMemo, useState } from "react";

import { classApi } from "../../../api/class";
import { token } from "../../../api/token";
import { GraphDrawing } from "../../../components/graph/GraphDrawing";
import { WorldPicture } from "../../../components/WorldPicture";
import { decimal } from "../../../i18n/numbers";
import { Said } from "../../../i18n/Said";
import { t } from "../../../i18n/words";
import { layoutStructure } from "../../../model/layout";
import { partsOf } from "../../../model/parts";
import { readStructure } from "../../../model/structure";
import { useStudio } from "../../../model/studio";
import { text } from "../../../model/texts";
import type { Program } from "../../../model/types";
import { Icon, useTheme } from "../../../theme";
import { Button } from "../../../ui/Button";
import { Tool } from "../../../ui/Tool";
import { codeWords } from "./JoinCard";
import { Comment } from "./Comment";
import { stateWords } from "./order";
import { act, freeze, look, say, useDesk } from "./store";

function Graph({ program, name }: { program: Program; name: string }) {
  const catalogue = useStudio((studio) => studio.catalogue);
  // Colours are written into the drawing: another theme is another drawing.
  const theme = useTheme((state) => state.theme);
  const layout = useMemo(
    () => layoutStructure(readStructure(program, partsOf(catalogue, program.robot))),
    [catalogue, program],
  );
  return (
    // It scrolls, and keys scroll what has the focus.
    <div className="class-look-graph scroll" role="region" aria-label={name} tabIndex={0}>
      <GraphDrawing key={theme} layout={layout} title={name} inside="" />
    </div>
  );
}

function Write({ folder, name }: { folder: string; name: string }) {
  const [words, setWords] = useState("");
  const send = (event: FormEvent) => {
    event.preventDefault();
    if (words.trim() === "") return;
    act(
      classApi.write(folder, words).then(() => {
        setWords("");
        say(t("teacher.written"));
      }),
    );
  };
  return (
    <form className="class-write rigid flex gap-m" onSubmit={send}>
      <input
        className="field"
        data-testid="write"
        value={words}
        maxLength={500}
        dir="auto"
        placeholder={t("teacher.write", { name })}
        aria-label={t("teacher.write", { name })}
        onChange={(event) => setWords(event.target.value)}
      />
      <Button icon="send" type="submit">
        {t("teacher.write-send")}
      </Button>
    </form>
  );
}

function Goals({ folder }: { folder: string }) {
  const { news, seen } = useDesk();
  const goals = seen.get(folder)?.pupil.goals ?? [];
  if (news === null || news.goals.length === 0) return null;
  return (
    <ul className="class-look-goals rigid scroll">
      {news.goals.map(({ label }, at) => {
        const goal = goals[at];
        const reached = goal?.reached === true;
        return (
          <li key={at} data-met={reached}>
            <Icon
              name={reached ? "circle-check" : "circle-dashed"}
              size={18}
              label={t(
                reached
                  ? "exercise.goal-reached"
                  : goal?.reached === false
                    ? "exercise.goal-missed"
                    : "exercise.goal-open",
              )}
            />
            <span>
              {text(label)}
              {goal === undefined || !goal.why ? null : (
                <small className="block regular">
                  <Said text={goal.why} />
                </small>
              )}
            </span>
          </li>
        );
      })}
    </ul>
  );
}

/** The arena of the pupil's page as it was told last: where the robots are, and the way of the first. */
function Arena({ name }: { name: string }) {
  const arena = useDesk((desk) => desk.arena);
  if (arena === null) return null;
  const { world, poses, way, running, seconds } = arena;
  // Drawn as starts: who stands somewhere in a world.
  const starts = poses.map(([x_mm, y_mm, heading_rad], at) => ({ name: String(at), x_mm, y_mm, heading_rad }));
  const shown = poses.length > 0 ? { ...world, starts } : world;
  const agents = shown.starts.map((start) => start.name);
  const points = way.map(([x, y]) => `${String(x)},${String(world.height_mm - y)}`).join(" ");
  const words = running
    ? t("teacher.arena-runs", { seconds: decimal(Math.round(seconds * 10) / 10) })
    : t(poses.length > 0 ? "teacher.arena-ended" : "teacher.arena-before", {
        seconds: decimal(Math.round(seconds * 10) / 10),
      });
  return (
    <figure
      className="class-arena rigid"
      data-testid="look-arena"
      data-running={running}
      aria-label={t("teacher.arena", { name })}
    >
      <figcaption>
        <strong>{t("teacher.arena", { name })}</strong> <span className="class-muted muted small-text">{words}</span>
      </figcaption>
      <WorldPicture world={shown} agents={agents}>
        <polyline className="class-way" points={points} style={{ strokeWidth: Math.max(4, world.width_mm / 300) }} />
      </WorldPicture>
    </figure>
  );
}

/** Asking the pupil to let the teacher edit; and once let in, the way to it and back. */
function Turn({ folder, copy }: { folder: string; copy: string }) {
  const pupil = useDesk(({ seen }) => seen.get(folder)?.pupil);
  if (pupil === undefined || pupil.file === "") return null;
  const { turn, name, pages } = pupil;
  if (turn === "pupil") {
    return (
      <button
        type="button"
        className="class-plain text-button inline-row"
        data-testid="ask-to-edit"
        disabled={pages === 0}
        onClick={() => act(classApi.turn(folder, true))}
      >
        <Icon name="pencil" size={16} />
        {t("teacher.ask-to-edit")}
      </button>
    );
  }
  return (
    <p className="row wrap wide" role="status" data-testid="turn">
      {t(turn === "asked" ? "teacher.asked-to-edit" : "teacher.may-edit", { name })}{" "}
      {turn === "asked" ? null : (
        <a className="button button-ink" href={copy} target="_blank" rel="noopener" data-testid="edit">
          {t("teacher.edit")}
        </a>
      )}
      <Button testId="give-back" onClick={() => act(classApi.turn(folder, false))}>
        {t(turn === "asked" ? "teacher.ask-no-more" : "teacher.give-back")}
      </Button>
    </p>
  );
}

/** The secret word of a pupil: shown when that is asked for, since a class may see the teacher's screen. */
function Word({ name, word }: { name: string; word: string }) {
  const [open, setOpen] = useState(false);
  return (
    <>
      {open ? (
        <span className="class-muted muted small-text" data-testid="look-word">
          {t("teacher.word", { name, word: codeWords(word) })}
        </span>
      ) : null}
      <button
        type="button"
        className="class-plain text-button inline-row"
        aria-expanded={open}
        data-testid="look-word-show"
        onClick={() => setOpen(!open)}
      >
        <Icon name="eye" size={16} />
        {t(open ? "teacher.word-hide" : "teacher.word-show")}
      </button>
    </>
  );
}

export function Look({ now }: { now: number }) {
  const { looked, seen, pictures, news } = useDesk();
  const [removing, setRemoving] = useState("");
  const one = seen.get(looked);
  if (one === undefined || news === null) return null;
  const { folder, name, file, frozen, state, turn, word } = one.pupil;
  const { icon, words } = stateWords(one, news.goals.length, now);
  const program = pictures.get(folder)?.program ?? null;
  const copy = `studio?token=${encodeURIComponent(token())}&open=${encodeURIComponent(`${folder}/${file}`)}`;
  return (
    <aside className="class-look column rigid" aria-label={name} data-testid="look">
      <header className="class-look-head row rigid">
        <h2 className="heading ellipsis" dir="auto">
          {name}
        </h2>
        <span className="class-muted muted small-text ellipsis" dir="auto">
          {file}
        </span>
        <span className="small-text bold rigid inline-row gap-s">
          <Icon name={icon} size={14} />
          {words}
        </span>
        {state === "asks" ? (
          <Button onClick={() => act(classApi.handDown(folder))}>{t("teacher.was-there")}</Button>
        ) : null}
        <Button
          icon="snowflake"

          aria-pressed={frozen}
          testId="look-freeze"
          onClick={() => freeze(!frozen, [folder])}
        >
          {t(frozen ? "teacher.go-on" : "teacher.freeze-one")}
        </Button>
        <Tool small icon="x" label={t("help.close")} titled={false} onClick={() => look("")} />
      </header>
      {turn === "teacher" ? null : (
        <p className="class-look-note row small-text rigid">
          <Icon name="eye" size={16} />
          {t("teacher.look-on", { name })}
        </p>
      )}
      {program === null ? (
        <p className="class-nobody muted text-centre">{t("teacher.look-none")}</p>
      ) : (
        <Graph program={program} name={name} />
      )}
      <Arena name={name} />
      <Goals folder={folder} />
      {news.exercise === "" ? null : (
        <Comment
          key={`${folder} ${news.exercise}`}
          folder={folder}
          name={name}
          exercise={news.exercise}
          mark={one.pupil.mark}
        />
      )}
      <div className="class-look-more row wrap rigid">
        <Turn folder={folder} copy={copy} />
        {file === "" ? null : (
          <a
            className="class-plain text-button inline-row"
            href={copy}
            target="_blank"
            rel="noopener"
            data-testid="look-copy"
          >
            <Icon name="maximize-2" size={16} />
            {t("teacher.look-large")}
          </a>
        )}
        <Word key={folder} name={name} word={word} />
        {removing === folder ? (
          <p role="alert" className="wide">
            {t("teacher.remove-sure", { name })}{" "}
            <Button data-removes="" onClick={() => act(classApi.remove(folder))}>
              {t("teacher.remove-yes")}
            </Button>
          </p>
        ) : (
          <button type="button" className="class-plain text-button inline-row" onClick={() => setRemoving(folder)}>
            <Icon name="trash-2" size={16} />
            {t("teacher.remove")}
          </button>
        )}
      </div>
      <Write key={folder} folder={folder} name={name} />
    </aside>
  );
}
