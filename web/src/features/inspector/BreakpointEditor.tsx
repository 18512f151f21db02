/** The breakpoint of the selected part: on or off, for whom, under which condition, from which visit on. */
import "./breakpoint-editor.css";

import { useState } from "react";

import { Switch } from "../../components/fields/FieldRow";
import { NumberInput } from "../../components/fields/NumberInput";
import { t } from "../../i18n/words";
import { breakpointAt, removeBreakpoint, setBreakpoint } from "../../model/commands/changeBreakpoints";
import { execute, useStudio } from "../../model/studio";
import type { Breakpoint } from "../../model/types";
import { instructionOf } from "../../session/breakpoints";
import { type Drawing, useDrawing } from "../../session/drawing";
import { keyFor } from "../../session/key-table";
import { Checkbox } from "../../ui/Checkbox";
import { Row } from "../../ui/Row";

const MOST_HITS = 1_000_000;

export function BreakpointEditor({ id }: { id: string }) {
  const drawing = useDrawing();
  const vertex = drawing === null ? null : instructionOf(drawing, id);
  if (drawing === null || vertex === null) return null;
  return <Editor key={vertex} drawing={drawing} vertex={vertex} />;
}

function Editor({ drawing, vertex }: { drawing: Drawing; vertex: string }) {
  const program = drawing.program.name;
  const breakpoint = useStudio(({ mission }) => breakpointAt(mission, program, vertex));
  const put = (made: Breakpoint | null) => {
    const { mission } = useStudio.getState();
    execute(made === null ? removeBreakpoint(mission, program, vertex) : setBreakpoint(drawing.parts, mission, made));
  };
  return (
    <section className="inspector-part" aria-label={t("debug.breakpoint")}>
      <div className="breakpoint-row row gap-xl">
        <span className="breakpoint-name row">
          <span className="breakpoint-dot" data-off={breakpoint === undefined} aria-hidden="true" />
          {t("debug.breakpoint")}
        </span>
        <kbd aria-hidden="true">{keyFor.graph("breakpoint")}</kbd>
        <Switch
          on={breakpoint !== undefined && breakpoint.enabled !== false}
          label={t("debug.breakpoint")}
          testid="breakpoint-switch"
          toggle={() => {
            if (breakpoint === undefined) put({ program, vertex });
            else if (breakpoint.enabled === false) put({ ...breakpoint, enabled: true });
            else if (isPlain(breakpoint)) put(null);
            else put({ ...breakpoint, enabled: false });
          }}
        />
      </div>
      {breakpoint === undefined ? null : (
        <>
          <When breakpoint={breakpoint} put={put} />
          <Hits breakpoint={breakpoint} put={put} />
          <Who breakpoint={breakpoint} put={put} />
        </>
      )}
    </section>
  );
}

/** Nothing of it would be lost if it were taken away. */
function isPlain({ when = "", hits = 1, agents = [], every = false }: Breakpoint): boolean {
  return when === "" && hits === 1 && agents.length === 0 && !every;
}

interface Part {
  breakpoint: Breakpoint;
  put: (made: Breakpoint) => void;
}

function When({ breakpoint, put }: Part) {
  const { when = "" } = breakpoint;
  const [text, setText] = useState(when);
  const [shown, setShown] = useState(when);
  if (when !== shown) {
    setShown(when);
    setText(when);
  }
  const keep = () => {
    if (text.trim() !== when) put({ ...breakpoint, when: text.trim() });
  };
  return (
    <Row label={t("debug.when")} className="breakpoint-row gap-xl" labelClass="breakpoint-name row">
      <input
        type="text"
        dir="ltr"
        className="field breakpoint-when slim"
        data-testid="breakpoint-when"
        placeholder="Count.GreaterThan(3)"
        maxLength={1000}
        spellCheck={false}
        value={text}
        onChange={(event) => setText(event.target.value)}
        onBlur={keep}
        onKeyDown={(event) => {
          if (event.key === "Enter") keep();
          else if (event.key === "Escape") setText(when);
        }}
      />
    </Row>
  );
}

function Hits({ breakpoint, put }: Part) {
  const { hits = 1 } = breakpoint;
  return (
    <Row label={t("debug.hits")} className="breakpoint-row gap-xl" labelClass="breakpoint-name row">
      <NumberInput
        className="field breakpoint-hits"
        testId="breakpoint-hits"
        min={1}
        max={MOST_HITS}
        whole
        value={hits}
        keep={(wanted) => put({ ...breakpoint, hits: wanted })}
      />
    </Row>
  );
}

function Who({ breakpoint, put }: Part) {
  const mission = useStudio((state) => state.mission);
  const names = mission.agents.filter((agent) => agent.program === breakpoint.program).map((agent) => agent.name);
  const { agents = [], every = false } = breakpoint;
  if (names.length < 2) return null;
  const watched = agents.length === 0 ? names : names.filter((name) => agents.includes(name));
  const toggle = (name: string) => {
    const next = watched.includes(name) ? watched.filter((one) => one !== name) : [...watched, name];
    const wanted = names.filter((one) => next.includes(one));
    if (wanted.length > 0) put({ ...breakpoint, agents: wanted.length === names.length ? [] : wanted });
  };
  return (
    <>
      <fieldset className="breakpoint-row breakpoint-who row gap-xl items-start">
        <legend className="breakpoint-name row">{t("debug.who")}</legend>
        <span className="breakpoint-agents wrap flex justify-end">
          {names.map((name) => (
            <Checkbox
              key={name}
              testId={`breakpoint-agent-${name}`}
              checked={watched.includes(name)}
              set={() => toggle(name)}
            >
              {name}
            </Checkbox>
          ))}
        </span>
      </fieldset>
      {watched.length < 2 ? null : (
        <div className="breakpoint-row row gap-xl">
          <span className="breakpoint-name row">{t("debug.every")}</span>
          <Switch
            on={every}
            label={t("debug.every")}
            testid="breakpoint-every"
            toggle={() => put({ ...breakpoint, every: !every })}
          />
        </div>
      )}
    </>
  );
}
