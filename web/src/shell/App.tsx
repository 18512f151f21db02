/**
 * The whole page: menus and tools, parts, graph, the right column, the bottom bar, and what lies over them.
 *
 * Measures are in look.md; the panels' own are in `layout.ts`. Rooms of the page know nothing of where they stand.
 */
import { type CSSProperties, type DragEvent, useEffect } from "react";

import { ArenaOrRobots } from "../boards/Place";
import { Code } from "../code/Code";
import { followBreakpoints } from "../debug/breakpoints";
import { takeSamples } from "../debug/samples";
import { WatchButton, WatchDock } from "../debug/WatchDock";
import { Canvas } from "../editor/Canvas";
import { useView } from "../editor/view";
import { Inspector } from "../inspector/Inspector";
import { useStudio } from "../model/studio";
import { OwnParts } from "../own/OwnParts";
import { Palette } from "../palette/Palette";
import { keepWorld } from "../parts/files";
import { ProblemList, ProblemsButton } from "../problems/ProblemsButton";
import { TeamPanel } from "../team/TeamTab";
import { keepTeamView, useTeam } from "../team/view";
import { WorldPanel } from "../world/WorldTab";
import { Tutorials } from "../tutorial/Tutorials";
import { NarrowTabs, useNarrow } from "../reach/Narrow";
import { t } from "../words/words";
import { reveal } from "./actions";
import { Banner } from "./Banner";
import { begin } from "./beginning";
import { Brand } from "./Brand";
import { checkAgain, keepChecking } from "./checking";
import { hearOfDisk, watchDisk } from "./disk";
import { complain, complainOfJournal, sayReturned, sayStranger, show, useDocument } from "./document";
import { EventStrip } from "./EventStrip";
import { isKept, keepJournal } from "./journal";
import { useKeys } from "./keys";
import { later } from "./later";
import { useLayout } from "./layout";
import { MenuBar } from "./MenuBar";
import { useMenus } from "./menus";
import { useOpenRecording } from "./recordings";
import { showRunProblems } from "./run-problems";
import { Separator } from "./Separator";
import { Tabs } from "./Tabs";
import { Title } from "./Title";
import { TeamStop, Toolbar } from "./Toolbar";
import { Watching } from "./Watching";
import "./chrome.css";
import "./layout.css";
import "./menus.css";
import "./strip.css";
import "./tabs.css";

const RecordingBar = later(() => import("./RecordingBar").then((chunk) => chunk.RecordingBar), complain);
const EmptyExtras = later(() => import("./EmptyExtras").then((chunk) => chunk.EmptyExtras), complain);
const Sheets = later(
  () => import("./Sheets").then((chunk) => chunk.Sheets),
  (cause) => {
    show(null);
    complain(cause);
  },
);

let begun = false;

/** Opens the first mission once, and keeps the report fresh while the page is there. */
function useDocumentFlow(): void {
  useEffect(() => {
    const onReturn = () => {
      sayReturned();
      checkAgain();
    };
    const offJournal = keepJournal(complainOfJournal, hearOfDisk, undefined, { onReturn, onStranger: sayStranger });
    const offDisk = watchDisk();
    const offWorld = keepWorld();
    const offTeam = keepTeamView();
    return () => {
      offWorld();
      offTeam();
      offJournal();
      offDisk();
    };
  }, []);
  useEffect(() => {
    if (!begun) {
      begun = true;
      void begin();
    }
    return keepChecking();
  }, []);
  useEffect(showRunProblems, []);
  // What had the focus may be gone with the mission before: keys go to the graph then.
  const opening = useDocument((document) => document.opening);
  useEffect(() => {
    if (!opening && document.activeElement === document.body) useView.getState().viewport?.focus();
  }, [opening]);
  useEffect(() => {
    const ends = [followBreakpoints(reveal), takeSamples()];
    return () => {
      for (const end of ends) end();
    };
  }, []);
  useEffect(() => {
    const ask = (event: BeforeUnloadEvent) => {
      if (useStudio.getState().dirty && !isKept()) event.preventDefault();
    };
    window.addEventListener("beforeunload", ask);
    return () => window.removeEventListener("beforeunload", ask);
  }, []);
}

/** What takes files in is fetched when some are dropped; the list of them does not outlive the event. */
function dropped(files: File[]): void {
  import("../parts/take").then(({ takeFiles }) => takeFiles(files), complain);
}

function carriesFile(event: DragEvent): boolean {
  return event.dataTransfer.types.includes("Files");
}

function Side() {
  const { sizes, folded } = useLayout();
  // The last open panel of the column takes what the others leave.
  const last = !folded.arena ? "arena" : !folded.code ? "code" : "inspector";
  const height = (panel: "inspector" | "code"): CSSProperties =>
    panel === last ? { flex: "1 1 0" } : { flex: `0 1 ${String(sizes[panel])}px` };
  return (
    <div className="side" style={{ width: sizes.side }}>
      {folded.inspector ? null : (
        <section className="side-part side-inspector" style={height("inspector")} aria-label={t("view.inspector")}>
          <Inspector />
        </section>
      )}
      {folded.inspector || last === "inspector" ? null : (
        <Separator edge="inspector" label={t("view.inspector")} along="y" />
      )}
      {folded.code ? null : (
        <section className="side-part side-code" style={height("code")} aria-label={t("view.code")}>
          <Code />
        </section>
      )}
      {folded.code || last === "code" ? null : <Separator edge="code" label={t("view.code")} along="y" />}
      {folded.arena ? null : (
        <section className="side-part side-arena" aria-label={t("view.arena")}>
          <ArenaOrRobots />
        </section>
      )}
    </div>
  );
}

export function App() {
  useDocumentFlow();
  useKeys();
  const menus = useMenus();
  const { sizes, folded } = useLayout();
  const ready = useDocument((document) => document.ready);
  const opening = useDocument((document) => document.opening);
  const recording = useOpenRecording();
  const overlay = useDocument((document) => document.overlay);
  const room = useNarrow((narrow) => narrow.room);
  const team = useTeam((state) => state.open || state.world);
  const side = !(folded.inspector && folded.code && folded.arena);

  return (
    <div
      className="studio"
      data-room={room ?? "graph"}
      aria-busy={opening}
      onDragOver={(event) => {
        if (carriesFile(event)) event.preventDefault();
      }}
      onDrop={(event) => {
        if (!carriesFile(event)) return;
        event.preventDefault();
        dropped([...event.dataTransfer.files]);
      }}
    >
      <header className="head">
        <div className="head-menu">
          <Brand />
          <MenuBar menus={menus} />
          <Title />
        </div>
        <Toolbar menus={menus} />
        <TeamStop />
      </header>
      <Banner />
      {recording === null ? null : <RecordingBar open={recording} />}
      <Watching />
      <div className="middle">
        {folded.palette ? null : (
          <nav className="parts-frame" aria-label={t("app.parts")}>
            <div className="parts" style={{ width: sizes.palette }}>
              {ready ? <Palette /> : null}
            </div>
            <Separator edge="palette" label={t("view.palette")} along="x" />
          </nav>
        )}
        <main className="centre" aria-label={t("app.canvas")}>
          <Tabs />
          <Tutorials />
          <div className="centre-panel">
            <div
              className="canvas-panel"
              id="canvas-panel"
              role="tabpanel"
              aria-label={t("app.canvas")}
              data-covered={team}
            >
              {ready ? <Canvas emptyExtras={<EmptyExtras />} /> : null}
            </div>
            {ready ? <TeamPanel /> : null}
            {ready ? <WorldPanel /> : null}
          </div>
          <ProblemList />
          <WatchDock />
        </main>
        {side ? (
          <aside className="side-frame" aria-label={t("app.side")}>
            <Separator edge="side" label={t("app.side")} along="x" sense={-1} />
            <Side />
          </aside>
        ) : null}
      </div>
      <footer className="bottom">
        <ProblemsButton />
        <WatchButton />
        <EventStrip />
      </footer>
      <NarrowTabs />
      <OwnParts />
      {overlay === null ? null : <Sheets overlay={overlay} />}
    </div>
  );
}
