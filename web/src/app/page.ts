/** What the page has without any feature: its mission, its programs and its look. A feature as the others are. */
import { t } from "../i18n/words";
import { type StudioState, useStudio } from "../model/studio";
import { goToProgram, moveActiveProgram, removeProgramNamed } from "../session/actions";
import { reportError, show } from "../session/document";
import type { Feature } from "../session/features";
import { keyFor } from "../session/key-table";
import { type Panel, useLayout } from "../session/layout";
import type { MenuEntries } from "../session/menu-table";
import { downloadMission, save } from "../session/saving";
import { chooseSimple, tellNeed, useNeed, useSimpleView } from "../session/simple-view";
import { type ThemeChoice, useTheme } from "../theme";
import { download } from "../ui/download";
import { later } from "../ui/later";
import { languageEntries, SPOKEN, themeEntries, THEMES } from "../ui/look-entries";
import { menuCheck, type MenuEntry, menuItem } from "../ui/menu-model";
import { robotEntries } from "./AddProgram";
import { KEYS } from "./page-keys";
import { renameInTab } from "./tab-rename";
import type * as sheetsModule from "./Sheets";

function fileEntries({ activeProgram, report }: StudioState): MenuEntries {
  const translated = report?.programs.some((program) => program.name === activeProgram) ?? false;
  const lll = t("file.download-lll", { name: activeProgram });
  return {
    open: [
      menuItem("file-new", t("file.new"), keyFor.page(KEYS.create), () => show("new")),
      menuItem("file-open", t("file.open"), keyFor.page(KEYS.open), () => show("open")),
    ],
    save: [
      menuItem("file-save", t("file.save"), keyFor.page(KEYS.save), save),
      menuItem("file-save-as", t("file.save-as"), keyFor.page(KEYS.saveAs), () => show("save-as")),
    ],
    download: [
      menuItem("file-download-krt", t("file.download-krt"), null, () => void downloadMission()),
      menuItem("file-download-lll", lll, null, downloadProgram, !translated),
    ],
  };
}

function historyEntries({ undo, redo, canUndo, canRedo, undoLabel, redoLabel }: StudioState): MenuEntries {
  const undoing = undoLabel === "" ? t("edit.undo") : t("edit.undo-what", { what: undoLabel });
  const redoing = redoLabel === "" ? t("edit.redo") : t("edit.redo-what", { what: redoLabel });
  return {
    history: [
      menuItem("edit-undo", undoing, keyFor.page(KEYS.undo), undo, !canUndo),
      menuItem("edit-redo", redoing, keyFor.page(KEYS.redo), redo, !canRedo),
    ],
  };
}

const PANELS: Panel[] = ["palette", "inspector", "code", "arena"];

const WORDS: Feature["words"] = {
  "file-download-lll": "search.source",
  "view-simple": "search.simple",
  ...Object.fromEntries(THEMES.map((theme) => [`view-${theme}`, "search.theme" as const])),
  ...Object.fromEntries(SPOKEN.map((language) => [`view-${language}`, "search.language" as const])),
};

function lookEntries(choice: ThemeChoice, folded: Record<Panel, boolean>): MenuEntry[] {
  return [
    { kind: "heading", id: "view-theme", label: t("view.theme") },
    ...themeEntries(choice),
    { kind: "heading", id: "view-language", label: t("view.language") },
    ...languageEntries(),
    { kind: "heading", id: "view-panels", label: t("view.panels") },
    ...PANELS.map((panel) =>
      menuCheck(`view-${panel}`, t(`view.${panel}`), !folded[panel], () => useLayout.getState().toggle(panel)),
    ),
  ];
}

function programEntries({ activeProgram, catalogue, mission }: StudioState): MenuEntries {
  const only = mission.programs.length === 1;
  const ask = () => renameInTab(activeProgram);
  const away = t("program.delete", { name: activeProgram });
  return {
    "new-program": [{ kind: "heading", id: "program-add", label: t("program.add") }, ...robotEntries(catalogue.robots)],
    program: [
      menuItem("program-rename", t("program.rename"), keyFor.page(KEYS.rename), ask),
      menuItem("program-next", t("program.next"), keyFor.page(KEYS.nextProgram), () => goToProgram(1), only),
      menuItem(
        "program-previous",
        t("program.previous"),
        keyFor.page(KEYS.previousProgram),
        () => goToProgram(-1),
        only,
      ),
      menuItem("program-later", t("program.later"), keyFor.page(KEYS.programLater), () => moveActiveProgram(1), only),
      menuItem(
        "program-earlier",
        t("program.earlier"),
        keyFor.page(KEYS.programEarlier),
        () => moveActiveProgram(-1),
        only,
      ),
      menuItem("program-delete", away, null, () => removeProgramNamed(activeProgram), only),
    ],
  };
}

/** The switch of the simple view; a mission that shows everything leaves nothing to switch. */
function useSimpleEntry(): MenuEntry {
  const needed = useNeed() !== null;
  const chosen = useSimpleView((view) => view.chosen);
  return {
    kind: "check",
    id: "view-simple",
    label: t("view.simple"),
    disabled: needed,
    checked: chosen && !needed,
    run: () => chooseSimple(!chosen),
  };
}

function useMenu(): MenuEntries {
  const studio = useStudio();
  const choice = useTheme((theme) => theme.choice);
  const folded = useLayout((layout) => layout.folded);
  const simple = useSimpleEntry();
  return {
    simple: [simple],
    ...fileEntries(studio),
    ...historyEntries(studio),
    ...programEntries(studio),
    look: lookEntries(choice, folded),
    help: [
      menuItem("help-shortcuts", t("help.shortcuts"), keyFor.page(KEYS.shortcuts), () => show("shortcuts")),
      menuItem("help-about", t("help.about"), null, () => show("about")),
    ],
  };
}

const inSheets = <Name extends keyof typeof sheetsModule>(name: Name, typing = false) =>
  later(
    () => import("./Sheets").then((chunk) => chunk[name]),
    (cause) => {
      show(null);
      reportError(cause);
    },
    { typing },
  );

declare module "../session/document" {
  interface Overlays {
    "save-as": true;
    shortcuts: true;
    about: true;
    difference: true;
  }
}

export const page: Feature = {
  name: "page",
  keys: KEYS,
  words: WORDS,
  elsewhere: [{ name: "help.keys-save", says: "elsewhere.merge", also: "search.merge" }],
  useMenu,
  start: tellNeed,
  sheets: {
    "save-as": inSheets("SaveAsSheet", true),
    shortcuts: inSheets("ShortcutsSheet", true),
    about: inSheets("AboutSheet"),
    difference: inSheets("DifferenceSheet"),
  },
};

/** The open program as a file for the person to keep. */
function downloadProgram(): void {
  const { activeProgram, report } = useStudio.getState();
  const found = report?.programs.find((program) => program.name === activeProgram);
  if (found !== undefined) download(`${activeProgram}.lll`, found.lll, "text/plain");
}
