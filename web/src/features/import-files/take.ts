/**
 * Files that a person drops or chooses: parts go beside the mission, programs as text into it, anything else is opened.
 *
 * Files go one after another, since one of them may need an answer: whether it may replace another of its name. What became
 * of all of them is said at the end, in one banner.
 */
import { ApiError } from "../../api/client";
import type { PartsFile } from "../../api/generated";
import { partsApi } from "../../api/parts";
import { type Failure, whyRefused } from "../../api/refusal";
import { type Key, listed, t } from "../../i18n/words";
import { changeWorld, sameWorld } from "../../model/commands/changeWorld";
import { execute, useStudio } from "../../model/studio";
import { addProgramFor } from "../../session/actions";
import { openDock } from "../../session/dock";
import {
  type Banner,
  type BannerAction,
  bannerAction,
  note,
  putBanner,
  question,
  useDocument,
} from "../../session/document";
import { openFromComputer } from "../../session/open-requests";
import { PROBLEMS } from "../../session/problem-walk";
import { showDifference } from "../../session/saving";
import { openTeam } from "../../session/team-view";
import { readParts } from "../../session/world-files";
import { isProgramText, takeProgramText } from "./program-text";

const MOST_MB = 4;
const LOOKED_AT = 4096;

/** What a file is to become: a program, or parts where it is XML and no mission; anything else is opened. */
async function readKind(file: File): Promise<"program" | "parts" | "other"> {
  const beginning = await file
    .slice(0, LOOKED_AT)
    .text()
    .catch(() => "");
  if (isProgramText(file.name, beginning)) return "program";
  return /\.xml$/i.test(file.name) && !/<kitrobot[\s>]/.test(beginning) ? "parts" : "other";
}

export async function takeFiles(files: readonly File[]): Promise<void> {
  const parts: File[] = [];
  const others: File[] = [];
  for (const file of files) {
    const kind = await readKind(file);
    if (kind === "program") await takeProgramText(file);
    else (kind === "parts" ? parts : others).push(file);
  }
  if (parts.length > 0) await takeParts(parts);
  // One mission is open at a time: the first file that may be one.
  const first = others.find((file) => /\.(krt|krtrace|svg|png|pdf|hex)$/i.test(file.name)) ?? others[0];
  if (first !== undefined) openFromComputer(first);
}

/** Lets the person choose files of parts, and of programs as text. */
export function chooseParts(): void {
  const input = document.createElement("input");
  input.type = "file";
  input.multiple = true;
  input.accept = ".xml,.lll,application/xml,text/xml";
  input.addEventListener("change", () => void takeFiles([...(input.files ?? [])]));
  input.click();
}

async function takeParts(files: readonly File[]): Promise<void> {
  const added: PartsFile[] = [];
  const refused: Failure[] = [];
  for (const file of files) {
    try {
      const found = await take(file);
      if (found !== null) added.push(found);
    } catch (cause) {
      refused.push(whyRefused(cause));
    }
  }
  if (added.length > 0) await readParts();
  tell(added, refused);
}

/** Puts one file beside the mission; null when the person would rather keep what is there. */
async function take(file: File): Promise<PartsFile | null> {
  const { name } = file;
  if (file.size > MOST_MB * 1024 * 1024) {
    throw new ApiError(t("parts.too-large", { file: name, most: MOST_MB }), t("parts.too-large-help"));
  }
  let bytes: ArrayBuffer;
  try {
    bytes = await file.arrayBuffer();
  } catch {
    throw new ApiError(t("parts.unreadable", { file: name }));
  }
  const { path } = useStudio.getState().file;
  try {
    return await partsApi.add(path, name, bytes);
  } catch (cause) {
    if (!(cause instanceof ApiError) || cause.status !== 409) throw cause;
    const changes = await partsApi.difference(path, name, bytes).catch(() => []);
    return (await mayReplace(name, changes)) ? partsApi.add(path, name, bytes, cause.revision) : null;
  }
}

/** Asks; a question that is overtaken by another banner is answered with no. `changes`: what is different, in words. */
function mayReplace(file: string, changes: readonly string[]): Promise<boolean> {
  return new Promise((resolve) => {
    let last: Banner | null = null;
    const ask = () => {
      question(t("parts.taken", { file }), [
        ["parts.replace", () => resolve(true)],
        ["parts.leave", () => resolve(false)],
        ...(changes.length > 0
          ? [["disk.difference", () => showDifference(ask, { file, changes })] satisfies [Key, () => void]]
          : []),
      ]);
      const asked = useDocument.getState().banner;
      last = asked;
      const off = useDocument.subscribe(({ banner }) => {
        if (banner === asked) return;
        off();
        // The answer itself comes first: it takes the banner away and then resolves, or asks again.
        setTimeout(() => {
          if (last === asked) resolve(false);
        });
      });
    };
    ask();
  });
}

function wordsFor({ file, kind, names, known }: PartsFile): string {
  if (names.length === 0) return t("parts.added-broken", { file });
  if (known) return t("parts.added-known", { file });
  const holes = { names: listed(names.slice(0, 6)), count: names.length };
  return t(`parts.added-${kind}`, holes);
}

/** What a person most likely does next with a part. */
function nextFor({ file, kind, names }: PartsFile): BannerAction[] {
  const { mission } = useStudio.getState();
  const [name] = names;
  if (name === undefined) {
    return [bannerAction(t("parts.see-problems"), () => openDock(PROBLEMS))];
  }
  if (kind === "robot" && !mission.programs.some((program) => program.robot === name)) {
    return [bannerAction(t("parts.write-program"), () => addProgramFor(name))];
  }
  if (kind === "world" && !sameWorld(mission.world, file)) {
    return [
      bannerAction(t("parts.use-world"), () => {
        execute(changeWorld(useStudio.getState().mission, file));
        openTeam();
      }),
    ];
  }
  return [];
}

function tell(added: readonly PartsFile[], refused: readonly { message: string; help: string }[]): void {
  if (added.length === 0 && refused.length === 0) return;
  const good = added.map(wordsFor).join(" ");
  const [only] = added;
  const actions = added.length === 1 && only !== undefined ? nextFor(only) : [];
  if (refused.length === 0) {
    note(good, "", actions);
    return;
  }
  const message = refused.map((one) => one.message).join(" ");
  const help = [refused[0]?.help ?? "", good].filter((words) => words !== "").join(" ");
  putBanner({ kind: "error", message, help, actions });
}
