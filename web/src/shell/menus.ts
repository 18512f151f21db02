/**
 * The menus: what the studio can do now, in words. What is not built is not here; what cannot be done at this moment is
 * there but cannot be chosen.
 */
import { useMemo } from "react";

import { runOnRobots, showRobots, stopEverything, useRobotsPanel } from "../boards/state";
import { useView, type Viewport } from "../editor/view";
import { ownConstructors } from "../model/own";
import { useStudio } from "../model/studio";
import { shareParts } from "../own/share";
import { canSave, openSave } from "../own/state";
import { keyFor } from "../reach/key-table";
import { explain, toggleOutline, useReach } from "../reach/state";
import { newVariable } from "../parts/variables";
import { openTeam } from "../team/view";
import { openWorld } from "../world/state";
import { canGoBack, isLive, useRun } from "../run/run";
import { type ThemeChoice, useTheme } from "../theme";
import { text } from "../model/texts";
import type { Tutorial } from "../api/tutorials";
import { begin as beginTutorial } from "../tutorial/opening";
import { useTutorial } from "../tutorial/state";
import { useLanguage } from "../words/language";
import { type Key, type Language, languageInUse, LANGUAGES, t } from "../words/words";
import { changeSpeed, goToProgram, moveActiveProgram, pause, removeProgramNamed, run, stepVertex } from "./actions";
import { printSheet } from "../out/print";
import { robotEntries } from "./AddProgram";
import { complain, newMission, save, show } from "./document";
import { downloadMission, downloadProgram, saveTheRun } from "./downloads";
import { editEntries, viewEntries } from "./graph-menu";
import { type Panel, useLayout } from "./layout";
import type { MenuEntry, MenuPart } from "./menu-model";
import { useRenaming } from "./renaming";

const line = (id: string): MenuEntry => ({ kind: "line", id });

/** What makes files to keep and sheets to print; fetched when somebody wants one: most never do. */
const pictures = () => import("../out/pictures");
const images = () => import("../out/images");

/** What takes files in is fetched when it is wanted. */
function addParts(): void {
  import("../parts/take").then(({ chooseParts }) => chooseParts(), complain);
}

function fileMenu(program: string, translated: boolean, several: boolean): MenuEntry[] {
  return [
    { kind: "item", id: "file-new", label: t("file.new"), keys: keyFor.page("create"), run: newMission },
    { kind: "item", id: "file-open", label: t("file.open"), keys: keyFor.page("open"), run: () => show("open") },
    { kind: "item", id: "file-parts", label: t("parts.add-file"), run: addParts },
    line("file-1"),
    { kind: "item", id: "file-save", label: t("file.save"), keys: keyFor.page("save"), run: () => void save() },
    {
      kind: "item",
      id: "file-save-as",
      label: t("file.save-as"),
      keys: keyFor.page("saveAs"),
      run: () => show("save-as"),
    },
    line("file-2"),
    { kind: "item", id: "file-download-krt", label: t("file.download-krt"), run: () => void downloadMission() },
    {
      kind: "item",
      id: "file-download-lll",
      label: t("file.download-lll", { name: program }),
      disabled: !translated,
      run: downloadProgram,
    },
    {
      kind: "item",
      id: "file-download-kri",
      label: t("out.download-kri", { name: program }),
      run: () => void images().then((out) => out.downloadImage()),
    },
    {
      kind: "item",
      id: "file-download-kra",
      label: t("out.download-kra", { name: program }),
      run: () => void images().then((out) => out.downloadListing()),
    },
    line("file-3"),
    {
      kind: "item",
      id: "file-export-svg",
      label: t("file.export-svg"),
      run: () => void pictures().then((out) => out.exportSvg()),
    },
    {
      kind: "item",
      id: "file-export-png",
      label: t("file.export-png"),
      run: () => void pictures().then((out) => out.exportPng()),
    },
    {
      kind: "item",
      id: "file-export-pdf",
      label: t("out.export-pdf"),
      run: () => void pictures().then((out) => out.exportPdf()),
    },
    {
      kind: "item",
      id: "file-export-pdf-all",
      label: t("out.export-pdf-all"),
      disabled: !several,
      run: () => void pictures().then((out) => out.exportPdfOfAll()),
    },
    line("file-4"),
    { kind: "item", id: "file-print", label: t("out.print"), keys: keyFor.page("print"), run: printSheet },
  ];
}

const THEMES: ThemeChoice[] = ["light", "dark", "contrast", "system"];
const SPOKEN = Object.keys(LANGUAGES) as Language[];
const PANELS: Panel[] = ["palette", "inspector", "code", "arena"];

function viewMenu(
  choice: ThemeChoice,
  folded: Record<Panel, boolean>,
  outline: boolean,
  viewport: Viewport | null,
): MenuEntry[] {
  return [
    ...viewEntries(viewport),
    { kind: "heading", id: "view-theme", label: t("view.theme") },
    ...THEMES.map((theme): MenuEntry => ({
      kind: "radio",
      id: `view-${theme}`,
      label: t(`view.${theme}` as Key),
      checked: choice === theme,
      run: () => useTheme.getState().choose(theme),
    })),
    { kind: "heading", id: "view-language", label: t("view.language") },
    ...SPOKEN.map((language): MenuEntry => ({
      kind: "radio",
      id: `view-${language}`,
      label: LANGUAGES[language].name,
      checked: languageInUse() === language,
      run: () => void useLanguage.getState().choose(language),
    })),
    { kind: "heading", id: "view-panels", label: t("view.panels") },
    ...PANELS.map((panel): MenuEntry => ({
      kind: "check",
      id: `view-${panel}`,
      label: t(`view.${panel}`),
      checked: !folded[panel],
      run: () => useLayout.getState().toggle(panel),
    })),
    {
      kind: "check",
      id: "view-outline",
      label: t("outline.title"),
      keys: keyFor.page("outline"),
      checked: outline,
      run: toggleOutline,
    },
  ];
}

function ownEntries(selected: boolean, own: boolean): MenuEntry[] {
  return [
    {
      kind: "item",
      id: "program-save-part",
      label: t("own.save"),
      keys: keyFor.graph("savePart"),
      disabled: !selected,
      run: () => void openSave(),
    },
    { kind: "item", id: "program-share-parts", label: t("own.share"), disabled: !own, run: () => void shareParts() },
  ];
}

function programMenu(robots: MenuEntry[], own: MenuEntry[], program: string, several: boolean): MenuEntry[] {
  return [
    { kind: "heading", id: "program-add", label: t("program.add") },
    ...robots,
    line("program-1"),
    ...own,
    line("program-2"),
    { kind: "item", id: "program-team", label: t("team.open"), keys: keyFor.page("team"), run: () => openTeam() },
    { kind: "item", id: "program-world", label: t("world.open"), keys: keyFor.page("world"), run: () => openWorld() },
    {
      kind: "item",
      id: "program-variable",
      label: t("variable.new-dots"),
      keys: keyFor.page("variable"),
      run: () => newVariable(),
    },
    line("program-2"),
    {
      kind: "item",
      id: "program-rename",
      label: t("program.rename"),
      keys: keyFor.page("rename"),
      run: () => useRenaming.setState({ program }),
    },
    ...neighbours(several),
    {
      kind: "item",
      id: "program-delete",
      label: t("program.delete", { name: program }),
      disabled: !several,
      run: () => removeProgramNamed(program),
    },
  ];
}

function neighbours(several: boolean): MenuEntry[] {
  const entry = (id: string, label: string, keys: string, go: () => void): MenuEntry => ({
    kind: "item",
    id: `program-${id}`,
    label,
    keys,
    disabled: !several,
    run: go,
  });
  return [
    entry("next", t("program.next"), keyFor.page("nextProgram"), () => goToProgram(1)),
    entry("previous", t("program.previous"), keyFor.page("previousProgram"), () => goToProgram(-1)),
    entry("later", t("program.later"), keyFor.page("programLater"), () => moveActiveProgram(1)),
    entry("earlier", t("program.earlier"), keyFor.page("programEarlier"), () => moveActiveProgram(-1)),
  ];
}

function runMenu(status: string, live: boolean, speed: number): MenuEntry[] {
  const { step, setSpeed, tick, name, watching, real } = useRun.getState();
  const goesBack = tick > 0 && canGoBack(useRun.getState().status) && !watching && !real;
  const paused = status === "paused" && !watching;
  return [
    {
      kind: "item",
      id: "run-run",
      label: paused ? t("run.resume") : t("run.run"),
      keys: keyFor.page("run"),
      disabled: live && !paused,
      run,
    },
    {
      kind: "item",
      id: "run-pause",
      label: t("run.pause"),
      keys: keyFor.page("pause"),
      disabled: status !== "running" || watching || real,
      run: pause,
    },
    {
      kind: "item",
      id: "run-step",
      label: t("run.step"),
      keys: keyFor.page("step"),
      disabled: !paused,
      run: () => step(),
    },
    {
      kind: "item",
      id: "run-step-vertex",
      label: t("run.step-vertex"),
      keys: keyFor.page("stepVertex"),
      disabled: !paused,
      run: () => stepVertex(false),
    },
    {
      kind: "item",
      id: "run-step-back",
      label: t("run.step-back"),
      keys: keyFor.page("stepBack"),
      disabled: !goesBack,
      run: () => step("tick", true),
    },
    {
      kind: "item",
      id: "run-step-vertex-back",
      label: t("run.step-vertex-back"),
      keys: keyFor.page("stepVertexBack"),
      disabled: !goesBack,
      run: () => stepVertex(true),
    },
    {
      kind: "item",
      id: "run-stop",
      label: t(watching ? "watching.leave" : "run.stop"),
      keys: keyFor.page("stop"),
      disabled: !live,
      run: stopEverything,
    },
    { kind: "item", id: "run-save", label: t("recording.save"), disabled: name === "", run: () => void saveTheRun() },
    { kind: "heading", id: "run-speed", label: t("run.speed") },
    { kind: "item", id: "run-slower", label: t("run.slower"), keys: keyFor.page("slower"), run: () => changeSpeed(-1) },
    { kind: "item", id: "run-faster", label: t("run.faster"), keys: keyFor.page("faster"), run: () => changeSpeed(1) },
    { kind: "radio", id: "run-real-time", label: t("run.real-time"), checked: speed === 1, run: () => setSpeed(1) },
    { kind: "radio", id: "run-as-fast", label: t("run.as-fast"), checked: speed === 0, run: () => setSpeed(0) },
  ];
}

function robotsMenu(open: boolean, running: number): MenuEntry[] {
  return [
    {
      kind: "check",
      id: "robots-panel",
      label: t("boards.panel"),
      keys: keyFor.page("robots"),
      checked: open,
      run: () => showRobots(!open),
    },
    line("robots-1"),
    { kind: "item", id: "robots-run", label: t("boards.run"), keys: keyFor.page("runOnRobot"), run: runOnRobots },
    {
      kind: "item",
      id: "robots-stop",
      label: t("boards.stop-all"),
      keys: keyFor.page("stop"),
      disabled: running === 0,
      run: stopEverything,
    },
  ];
}

function helpMenu(tutorials: readonly Tutorial[]): MenuEntry[] {
  const usable = tutorials.filter(({ steps }) => steps.length > 0);
  return [
    ...(usable.length > 0 ? [{ kind: "heading", id: "help-tutorials", label: t("tutorial.title") } as const] : []),
    ...usable.map((tutorial): MenuEntry => ({
      kind: "item",
      id: `help-tutorial-${tutorial.name}`,
      label: text(tutorial.label),
      run: () => void beginTutorial(tutorial),
    })),
    ...(usable.length > 0 ? [line("help-1")] : []),
    { kind: "item", id: "help-part", label: t("help.part"), keys: keyFor.page("part"), run: explain },
    {
      kind: "item",
      id: "help-shortcuts",
      label: t("help.shortcuts"),
      keys: keyFor.page("shortcuts"),
      run: () => show("shortcuts"),
    },
    { kind: "item", id: "help-about", label: t("help.about"), run: () => show("about") },
  ];
}

export function useMenus(): MenuPart[] {
  const studio = useStudio();
  const status = useRun((state) => state.status);
  const speed = useRun((state) => state.speed);
  const robots = useRobotsPanel();
  const choice = useTheme((theme) => theme.choice);
  const folded = useLayout((layout) => layout.folded);
  const outline = useReach((reach) => reach.outline);
  const viewport = useView((view) => view.viewport);
  const tutorials = useTutorial(({ all }) => all);
  return useMemo(() => {
    const { activeProgram, report, catalogue, mission } = studio;
    const translated = report?.programs.some((program) => program.name === activeProgram) ?? false;
    return [
      { id: "File", label: t("menu.file"), entries: fileMenu(activeProgram, translated, mission.programs.length > 1) },
      { id: "Edit", label: t("menu.edit"), entries: editEntries(studio) },
      { id: "View", label: t("menu.view"), entries: viewMenu(choice, folded, outline, viewport) },
      {
        id: "Program",
        label: t("menu.program"),
        entries: programMenu(
          robotEntries(catalogue.robots),
          ownEntries(studio.selection.length > 0 && canSave(), ownConstructors(mission).length > 0),
          activeProgram,
          mission.programs.length > 1,
        ),
      },
      { id: "Run", label: t("menu.run"), entries: runMenu(status, isLive(status), speed) },
      { id: "Robots", label: t("menu.robots"), entries: robotsMenu(robots.open, robots.running) },
      { id: "Help", label: t("menu.help"), entries: helpMenu(tutorials ?? []) },
    ];
  }, [studio, status, speed, robots, choice, folded, outline, viewport, tutorials]);
}
