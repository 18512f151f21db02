/**
 * The menus: what the studio can do now, in words. What is not built is not here; what cannot be done at this moment is
 * there but cannot be chosen.
 */
import { useMemo } from "react";

import { useView, type Viewport } from "../editor/view";
import { useStudio } from "../model/studio";
import { explain, toggleOutline, useReach } from "../reach/state";
import { isLive, useRun } from "../run/run";
import { type ThemeChoice, useTheme } from "../theme";
import { useLanguage } from "../words/language";
import { type Key, type Language, languageInUse, LANGUAGES, t } from "../words/words";
import { nextSpeed, pause, removeProgramNamed, run } from "./actions";
import { robotEntries } from "./AddProgram";
import { downloadMission, downloadProgram, newMission, save, show } from "./document";
import { editEntries, viewEntries } from "./graph-menu";
import { type Panel, useLayout } from "./layout";
import type { MenuEntry, MenuPart } from "./menu-model";
import { useRenaming } from "./renaming";

const line = (id: string): MenuEntry => ({ kind: "line", id });

function fileMenu(program: string, translated: boolean): MenuEntry[] {
  return [
    { kind: "item", id: "file-new", label: t("file.new"), keys: "Ctrl+Alt+N", run: newMission },
    { kind: "item", id: "file-open", label: t("file.open"), keys: "Ctrl+O", run: () => show("open") },
    line("file-1"),
    { kind: "item", id: "file-save", label: t("file.save"), keys: "Ctrl+S", run: () => void save() },
    { kind: "item", id: "file-save-as", label: t("file.save-as"), keys: "Ctrl+Shift+S", run: () => show("save-as") },
    line("file-2"),
    { kind: "item", id: "file-download-krt", label: t("file.download-krt"), run: () => void downloadMission() },
    {
      kind: "item",
      id: "file-download-lll",
      label: t("file.download-lll", { name: program }),
      disabled: !translated,
      run: downloadProgram,
    },
    line("file-3"),
    // Fetched when somebody wants a picture: most never do.
    {
      kind: "item",
      id: "file-export-svg",
      label: t("file.export-svg"),
      run: () => void import("../out/pictures").then((out) => out.exportSvg()),
    },
    {
      kind: "item",
      id: "file-export-png",
      label: t("file.export-png"),
      run: () => void import("../out/pictures").then((out) => out.exportPng()),
    },
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
      keys: "F4",
      checked: outline,
      run: toggleOutline,
    },
  ];
}

function programMenu(robots: MenuEntry[], program: string, several: boolean): MenuEntry[] {
  return [
    { kind: "heading", id: "program-add", label: t("program.add") },
    ...robots,
    line("program-1"),
    {
      kind: "item",
      id: "program-rename",
      label: t("program.rename"),
      keys: "F2",
      run: () => useRenaming.setState({ program }),
    },
    {
      kind: "item",
      id: "program-delete",
      label: t("program.delete", { name: program }),
      disabled: !several,
      run: () => removeProgramNamed(program),
    },
  ];
}

function runMenu(status: string, live: boolean, speed: number): MenuEntry[] {
  const { stop, step, setSpeed } = useRun.getState();
  const paused = status === "paused";
  return [
    {
      kind: "item",
      id: "run-run",
      label: paused ? t("run.resume") : t("run.run"),
      keys: "F5",
      disabled: live && !paused,
      run,
    },
    { kind: "item", id: "run-pause", label: t("run.pause"), keys: "F6", disabled: status !== "running", run: pause },
    { kind: "item", id: "run-step", label: t("run.step"), keys: "F10", disabled: !paused, run: step },
    { kind: "item", id: "run-stop", label: t("run.stop"), keys: "Shift+F5", disabled: !live, run: stop },
    { kind: "heading", id: "run-speed", label: t("run.speed") },
    { kind: "item", id: "run-slower", label: t("run.slower"), run: () => setSpeed(nextSpeed(speed, -1)) },
    { kind: "item", id: "run-faster", label: t("run.faster"), run: () => setSpeed(nextSpeed(speed, 1)) },
    { kind: "radio", id: "run-real-time", label: t("run.real-time"), checked: speed === 1, run: () => setSpeed(1) },
    { kind: "radio", id: "run-as-fast", label: t("run.as-fast"), checked: speed === 0, run: () => setSpeed(0) },
  ];
}

function helpMenu(): MenuEntry[] {
  return [
    { kind: "item", id: "help-part", label: t("help.part"), keys: "F1", run: explain },
    { kind: "item", id: "help-shortcuts", label: t("help.shortcuts"), keys: "?", run: () => show("shortcuts") },
    { kind: "item", id: "help-about", label: t("help.about"), run: () => show("about") },
  ];
}

export function useMenus(): MenuPart[] {
  const studio = useStudio();
  const status = useRun((state) => state.status);
  const speed = useRun((state) => state.speed);
  const choice = useTheme((theme) => theme.choice);
  const folded = useLayout((layout) => layout.folded);
  const outline = useReach((reach) => reach.outline);
  const viewport = useView((view) => view.viewport);
  return useMemo(() => {
    const { activeProgram, report, catalogue, mission } = studio;
    const translated = report?.programs.some((program) => program.name === activeProgram) ?? false;
    return [
      { id: "File", label: t("menu.file"), entries: fileMenu(activeProgram, translated) },
      { id: "Edit", label: t("menu.edit"), entries: editEntries(studio) },
      { id: "View", label: t("menu.view"), entries: viewMenu(choice, folded, outline, viewport) },
      {
        id: "Program",
        label: t("menu.program"),
        entries: programMenu(robotEntries(catalogue.robots), activeProgram, mission.programs.length > 1),
      },
      { id: "Run", label: t("menu.run"), entries: runMenu(status, isLive(status), speed) },
      { id: "Help", label: t("menu.help"), entries: helpMenu() },
    ];
  }, [studio, status, speed, choice, folded, outline, viewport]);
}
