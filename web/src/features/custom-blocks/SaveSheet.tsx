/** A selection becomes a part: how it is called and drawn, what is left open, how it will look. */
import { type FormEvent, useEffect, useMemo, useState } from "react";

import type { Offered, Part, PartWish } from "../../api/generated";
import { type Failure, whyRefused } from "../../api/refusal";
import { sentence, t } from "../../i18n/words";
import { saveAsPart } from "../../model/commands/ownParts";
import { catalogueOf, ownConstructors } from "../../model/own-parts";
import { partsOf } from "../../model/parts";
import { execute, useStudio } from "../../model/studio";
import type { Mission } from "../../model/types";
import { closeSheet } from "../../session/custom-blocks";
import { Checkbox } from "../../ui/Checkbox";
import { afterPause, awaitAnswer } from "../../ui/effects";
import { Sheet } from "../../ui/Sheet";
import { Look, type LookOf } from "./Look";
import { freePartName, plainName, wrongWith } from "./naming";
import { chosenOf, type Opening, openingsOf } from "./openings";
import { Openings } from "./Openings";
import { PartCode, Preview } from "./Preview";
import { partsApi } from "./server";
import { SheetEnd } from "./SheetEnd";

/** The pause after a key before the part is made anew. */
const PAUSE_MS = 150;

function firstLook(program: string, vertices: readonly string[]): LookOf {
  const { catalogue, mission } = useStudio.getState();
  const found = mission.programs.find((one) => one.name === program);
  const element = found?.vertices.find((one) => vertices.includes(one.id))?.element ?? "";
  const shape = partsOf(catalogue, found?.robot ?? "").shape(element);
  const icon = shape.method?.icon || shape.icon;
  return { name: freePartName(catalogue), help: "", icon, colour: shape.colour };
}

function saidOf(refused: Failure | null): string {
  if (refused === null) return "";
  return [sentence(refused.message), sentence(refused.help)].filter((one) => one !== "").join(" ");
}

export function whyNot(cause: unknown): string {
  return saidOf(whyRefused(cause));
}

export function SaveSheet({ program, vertices }: { program: string; vertices: string[] }) {
  const catalogue = useStudio((studio) => studio.catalogue);
  const mission = useStudio((studio) => studio.mission);
  const [look, setLook] = useState(() => firstLook(program, vertices));
  const [offered, setOffered] = useState<Offered | null>(null);
  const [openings, setOpenings] = useState<Opening[]>([]);
  const [inPlace, setInPlace] = useState(true);
  const [made, setMade] = useState<{ part: Part; mission: Mission } | null>(null);
  const [failure, setFailure] = useState("");
  const wrong = wrongWith(look.name, catalogue);

  useEffect(() => {
    const { file, mission: now } = useStudio.getState();
    return awaitAnswer(
      partsApi.offer({ mission: now, path: file.path, program, vertices }),
      (answer) => {
        if (answer.offered === null) setFailure(saidOf(answer.refused));
        setOffered(answer.offered);
        setOpenings(openingsOf(answer.offered?.offers ?? []));
      },
      (cause) => setFailure(whyNot(cause)),
    );
  }, [program, vertices]);

  const wish = useMemo((): PartWish | null => {
    if (offered === null || wrong !== "") return null;
    const { file } = useStudio.getState();
    const help: Record<string, string> = look.help.trim() === "" ? {} : { "": look.help.trim() };
    const { icon, colour } = look;
    const chosen = chosenOf(openings);
    const name = plainName(look.name);
    return { mission, path: file.path, program, vertices, name, icon, colour, label: {}, help, chosen };
  }, [offered, wrong, look, openings, mission, program, vertices]);

  useEffect(() => {
    if (wish === null) return;
    return afterPause(PAUSE_MS, () =>
      awaitAnswer(
        partsApi.make(wish),
        ({ part, refused }) => {
          setMade(part === null ? null : { part, mission: wish.mission });
          setFailure(saidOf(refused));
        },
        (cause) => {
          setMade(null);
          setFailure(whyNot(cause));
        },
      ),
    );
  }, [wish]);

  const save = async () => {
    if (wish === null) return;
    try {
      const { part, refused } = await partsApi.make(wish);
      if (part === null) {
        setFailure(saidOf(refused));
        return;
      }
      if (useStudio.getState().mission !== wish.mission) {
        setFailure(t("own.changed"));
        return;
      }
      if (execute(saveAsPart(wish.mission, part.constructor, inPlace ? part : null))) closeSheet();
    } catch (cause) {
      setFailure(whyNot(cause));
    }
  };
  const onSubmit = (event: FormEvent) => {
    event.preventDefault();
    void save();
  };

  const withPart = useMemo(() => {
    if (made === null) return null;
    const constructors = [...ownConstructors(made.mission), made.part.constructor];
    return catalogueOf(useStudio.getState().files, { ...made.mission, constructors });
  }, [made]);

  return (
    <Sheet title={t("own.save-title")} testId="own-dialog" wide onClose={closeSheet}>
      <form className="own-form" onSubmit={onSubmit}>
        <div className="own-columns">
          <div className="slim">
            <Look look={look} wrong={wrong} onChange={setLook} />
          </div>
          <div className="slim">
            <h3>{t("own.preview")}</h3>
            {made === null || withPart === null ? (
              <p className="sheet-note muted small-text">
                {offered === null && failure === "" ? t("own.waiting") : "…"}
              </p>
            ) : (
              <>
                <Preview
                  catalogue={withPart}
                  program={made.part.program}
                  vertex={made.part.vertex}
                  title={made.part.constructor.name}
                />
                <h3>{t("own.lll")}</h3>
                <PartCode lll={made.part.lll} />
              </>
            )}
          </div>
        </div>
        {offered === null ? null : <Openings program={program} openings={openings} onChange={setOpenings} />}
        <Checkbox testId="own-in-place" checked={inPlace} set={setInPlace}>
          {t("own.in-place")}
        </Checkbox>
        <SheetEnd why={failure} keep={t("own.saving")} disabled={wish === null || failure !== ""} />
      </form>
    </Sheet>
  );
}
