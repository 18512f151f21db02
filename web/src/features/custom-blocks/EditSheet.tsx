/** A part is changed: how it is called and drawn, its LLL, and the words and ranges of what can be set. */
import { type FormEvent, useEffect, useMemo, useRef, useState } from "react";

import type { PartRead } from "../../api/generated";
import { TextEditor } from "../../components/text/TextEditor";
import { languageInUse, sentence, t } from "../../i18n/words";
import { usesOfConstructor } from "../../model/commands/changeOwn";
import { changePart } from "../../model/commands/ownParts";
import { execute, programInView, useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import type { Constructor, Problem, Slot } from "../../model/types";
import { closeSheet } from "../../session/custom-blocks";
import { afterPause, awaitAnswer } from "../../ui/effects";
import { Sheet } from "../../ui/Sheet";
import { Look, type LookOf } from "./Look";
import { ownPart, plainName, wrongWith } from "./naming";
import { whyNot } from "./SaveSheet";
import { partsApi } from "./server";
import { SheetEnd } from "./SheetEnd";
import { Slots } from "./Slots";

const PAUSE_MS = 150;
const SHOWN = { active: new Map<number, number[]>(), selected: [] };
const nothing = () => undefined;

/** The words in the page's language where the part has some, else the default ones. */
function withWords(texts: Record<string, string>, words: string): Record<string, string> {
  const language = languageInUse();
  const key = language in texts ? language : "";
  const { [key]: _, ...rest } = texts;
  return words.trim() === "" ? rest : { ...rest, [key]: words.trim() };
}

export function EditSheet({ name }: { name: string }) {
  const found = useStudio((studio) => ownPart(studio.mission, name));
  if (found === undefined) return null;
  return <Editing name={name} part={found} />;
}

function Editing({ name, part }: { name: string; part: Constructor }) {
  const catalogue = useStudio((studio) => studio.catalogue);
  const robot = useStudio(robotFor(name));
  const [look, setLook] = useState<LookOf>({
    name,
    help: text(part.help),
    icon: part.icon,
    colour: part.colour,
  });
  const [code, setCode] = useState<string | null>(null);
  const [slots, setSlots] = useState<Slot[]>(part.slots);
  const [read, setRead] = useState<PartRead | null>(null);
  const [failure, setFailure] = useState("");
  const wrong = wrongWith(look.name, catalogue, name);
  const latest = useRef(part);

  const draft = useMemo((): Constructor => {
    const help = withWords(part.help, look.help);
    const named = plainName(look.name) || name;
    return { ...part, name: named, icon: look.icon, colour: look.colour, help, slots, code: code ?? part.code };
  }, [part, name, look, slots, code]);

  useEffect(() => {
    latest.current = draft;
    return afterPause(PAUSE_MS, () => {
      const { mission, file } = useStudio.getState();
      return awaitAnswer(
        partsApi.read(mission, file.path, robot, draft),
        (answer) => {
          setRead(answer);
          setFailure("");
          setCode((before) => before ?? answer.lll.trimEnd());
          if (answer.constructor !== null) setSlots((before) => sameSlots(before, answer.constructor?.slots ?? []));
        },
        (cause) => setFailure(whyNot(cause)),
      );
    });
  }, [draft, robot]);

  const problems = useMemo(
    (): Problem[] => read?.problems.filter((one) => one.line > 0).map((one) => ({ ...one, arcs: [] })) ?? [],
    [read],
  );
  const first = read?.constructor === null ? read.problems[0] : undefined;
  const changesRole =
    read?.constructor != null &&
    read.constructor.role !== part.role &&
    usesOfConstructor(useStudio.getState().mission, name).length > 0;
  const why =
    failure ||
    (changesRole ? t("own.role") : "") ||
    (first === undefined ? "" : [sentence(first.message), sentence(first.help)].filter(Boolean).join(" "));

  const save = async () => {
    const studio = useStudio.getState();
    try {
      const answer = await partsApi.read(studio.mission, studio.file.path, robot, latest.current);
      setRead(answer);
      if (answer.constructor === null) return;
      const now = useStudio.getState();
      execute(changePart(now.mission, now.files, name, answer.constructor));
      closeSheet();
    } catch (cause) {
      setFailure(whyNot(cause));
    }
  };
  const onSubmit = (event: FormEvent) => {
    event.preventDefault();
    if (wrong === "" && why === "") void save();
  };
  const around = useMemo(
    () => ({
      program: "part",
      parts: () => ({ catalogue, robot: catalogue.robots.find((one) => one.name === robot) }),
      elementAt: () => null,
    }),
    [catalogue, robot],
  );

  return (
    <Sheet title={t("own.edit-title", { name })} testId="own-dialog" wide onClose={closeSheet}>
      <form className="own-form" onSubmit={onSubmit}>
        <div className="own-columns">
          <div className="slim">
            <Look look={look} wrong={wrong} onChange={setLook} />
          </div>
          <div className="slim">
            <h3>{t("own.lll")}</h3>
            <div className="own-code own-code-edit small-text scroll typed">
              <TextEditor
                text={code ?? part.code}
                label={t("own.lll")}
                empty=""
                shown={SHOWN}
                problems={problems}
                settled={false}
                around={around}
                writes
                onType={setCode}
                onFocus={nothing}
                onPick={nothing}
                onPoint={nothing}
              />
            </div>
            <p className="sheet-note muted small-text">{t("own.slots-how")}</p>
          </div>
        </div>
        <Slots slots={slots} onChange={setSlots} />
        <SheetEnd why={why} keep={t("own.changing")} disabled={wrong !== "" || why !== "" || read === null} />
      </form>
    </Sheet>
  );
}

/** The robot whose parameters a new slot is given to: of a program that uses the part, or of the one in view. */
function robotFor(name: string) {
  return (studio: ReturnType<typeof useStudio.getState>): string => {
    const user = studio.mission.programs.find(({ vertices }) => vertices.some((one) => one.element === name));
    return (user ?? programInView(studio))?.robot ?? "";
  };
}

/** The slots that were read; the very same ones where nothing changed, so that nothing is read again for it. */
function sameSlots(before: Slot[], after: Slot[]): Slot[] {
  return JSON.stringify(before) === JSON.stringify(after) ? before : after;
}
