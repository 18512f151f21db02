/**
 * Asks what a robot is built of, with a card for each kit: its picture, its name, and whether the program runs there.
 *
 * Arrows walk from card to card, Enter takes one, Escape leaves everything as it was and sends nothing.
 */
import "./kits.css";

import { type KeyboardEvent, type ReactNode, useCallback, useEffect, useRef } from "react";

import type { KitFit } from "../../api/generated";
import { partsApi } from "../../api/parts";
import { RobotPicture } from "../../components/RobotPicture";
import { Said } from "../../i18n/Said";
import { listed, t } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { Icon } from "../../theme";
import { nextCard } from "../../ui/grid";
import { Sheet } from "../../ui/Sheet";
import { useFetched } from "../../ui/use-fetched";
import { kitFor, knowsKit, programFor, useBoards } from "./boards";
import { chooseKit, dropKitQuestion, useKitQuestion, useKitsAt } from "./kits";

interface Card {
  kit: string;
  label: string;
  help: string;
  picture: ReactNode;
  fit: KitFit | undefined;
}

/** Those on which the program runs come first; the robot's own file stands before the kits that are no better. */
function inOrder(cards: readonly Card[]): Card[] {
  const worth = ({ fit }: Card) => (fit === undefined || fit.problem === "" ? 0 : 1);
  return [...cards].sort((a, b) => worth(a) - worth(b));
}

/** Whether the program runs there, in words and with a sign. */
function Fit({ fit }: { fit: KitFit | undefined }) {
  if (fit === undefined) return null;
  const { missing, problem } = fit;
  const runs = problem === "";
  return (
    <span className="kit-fit muted small-text flex gap-xs items-start" data-runs={runs}>
      <Icon name={runs ? "check" : "x"} size={14} />
      <span>
        {runs ? (
          t("kits.runs")
        ) : missing.length > 0 ? (
          t("kits.lacks", { parts: listed(missing.map(({ part, label }) => text(label, part))) })
        ) : (
          <Said text={problem} />
        )}
      </span>
    </span>
  );
}

/** Which kits the program runs on; null before that is known, nothing where it cannot be had. */
function useFits(program: string): readonly KitFit[] | null {
  const path = useStudio((studio) => studio.file.path);
  const mission = useStudio((studio) => studio.mission);
  const ask = useCallback(() => partsApi.fits(path, mission, program), [path, mission, program]);
  return useFetched(ask, () => []);
}

export function KitSheet() {
  const address = useKitQuestion(({ asking }) => asking?.address);
  return address === undefined ? null : <Question key={address} address={address} />;
}

function Question({ address }: { address: string }) {
  const state = useBoards();
  const programs = useStudio((studio) => studio.mission.programs);
  const open = useStudio((studio) => studio.activeProgram);
  const names = programs.map(({ name }) => name);
  const program = programFor(state, address, names, open);
  const robot = programs.find(({ name }) => name === program)?.robot ?? "";
  const kits = useKitsAt(useStudio((studio) => studio.file.path));
  const fits = useFits(program);
  const chosen = knowsKit(state, address) ? kitFor(state, address) : null;
  const list = useRef<HTMLUListElement>(null);
  const fitOf = (kit: string) => fits?.find((one) => one.kit === kit);
  const own: Card = {
    kit: "",
    label: t("boards.kit-own"),
    help: t("kits.own-help"),
    picture: <RobotPicture kind={robot} index={0} />,
    fit: fitOf(""),
  };
  const cards = inOrder([
    own,
    ...(kits ?? []).map(({ name, label, help, picture }) => ({
      kit: name,
      label: text(label, name),
      help: text(help),
      picture: <img src={`data:image/svg+xml,${encodeURIComponent(picture)}`} alt="" />,
      fit: fitOf(name),
    })),
  ]);
  const buttons = () => [...(list.current?.querySelectorAll<HTMLElement>("button") ?? [])];
  // Their order tells which run: nothing is drawn before that is known, so that no card moves away from under a pointer.
  const there = fits !== null && kits !== null;
  useEffect(() => {
    if (!there) return;
    const all = [...(list.current?.querySelectorAll<HTMLElement>("button") ?? [])];
    (all.find((one) => one.ariaPressed === "true") ?? all[0])?.focus();
  }, [there]);
  const move = (event: KeyboardEvent<HTMLButtonElement>) => {
    const all = buttons();
    const places = all.map((card) => card.getBoundingClientRect());
    const to = nextCard(event.key, all.indexOf(event.currentTarget), places, document.dir === "rtl");
    if (to === null) return;
    event.preventDefault();
    all[to]?.focus();
  };
  return (
    <Sheet title={t("kits.title")} testId="kit-question" wide onClose={dropKitQuestion}>
      <p className="sheet-note muted small-text">
        <Said text={t("kits.help", { program })} />
      </p>
      <ul className="kit-cards card-grid" ref={list}>
        {(there ? cards : []).map(({ kit, label, help, picture, fit }) => (
          <li key={kit}>
            <button
              type="button"
              className="kit-card card surface column wide breakable gap-2xs"
              data-testid="kit-card"
              data-kit={kit}
              aria-pressed={kit === chosen}
              title={help}
              onClick={() => chooseKit(address, kit)}
              onKeyDown={move}
            >
              <span className="kit-picture card-picture centred">{picture}</span>
              <strong>{label}</strong>
              <Fit fit={fit} />
            </button>
          </li>
        ))}
      </ul>
    </Sheet>
  );
}
