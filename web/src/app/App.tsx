/**
 * The whole page: menus and tools, parts, graph, the right column, the bottom bar, and what lies over them.
 *
 * Sizes of panels are in `session/layout.ts`. Features do not depend on where they are placed.
 */
import "./chrome.css";
import "./layout.css";
import "../ui/menus.css";
import "./tabs.css";
import "./features";

import { type CSSProperties, useEffect } from "react";

import { Dock, PanelSlot, Slot } from "../components/Slot";
import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { checkAgain, keepChecking } from "../session/checking";
import { hearOfDisk, watchDisk } from "../session/disk";
import { useDocument } from "../session/document";
import { hasEarlyWork } from "../session/early-work";
import { features } from "../session/features";
import { flush, isKept, keepJournal } from "../session/journal";
import { reportJournalFault, sayReturned, sayStranger, sayWhenBack } from "../session/journal-notices";
import { useLayout } from "../session/layout";
import { useMobileRoom } from "../session/narrow";
import { useStage } from "../session/stage";
import { keepTeamView, useTeam } from "../session/team-view";
import { useView } from "../session/view";
import { keepWorld } from "../session/world-files";
import { endAll, listen } from "../ui/effects";
import { fileDrop } from "../ui/file-drop";
import { Banner } from "./Banner";
import { begin } from "./startup";
import { useKeys } from "./keys";
import { MenuBar } from "./MenuBar";
import { useMenus } from "./menus";
import { Separator } from "./Separator";
import { Tabs } from "./Tabs";
import { Title } from "./Title";
import { TeamStop, Toolbar } from "./Toolbar";

let begun = false;

/** Keeps what is done in the journal as long as the page is there, in whatever language it is drawn. Draws nothing. */
export function Journal() {
  useEffect(() => {
    const onReturn = () => {
      sayReturned();
      checkAgain();
    };
    const offBack = sayWhenBack();
    const stop = keepJournal(reportJournalFault, hearOfDisk, undefined, { onReturn, onStranger: sayStranger });
    return endAll(offBack, stop);
  }, []);
  return null;
}

/** Opens the first mission once, and keeps the report fresh while the page is there. */
function useDocumentFlow(): void {
  useEffect(() => endAll(watchDisk(), keepWorld(), keepTeamView()), []);
  useEffect(() => {
    if (!begun) {
      begun = true;
      void begin();
    }
    return keepChecking();
  }, []);
  // What had the focus may be gone with the mission before: keys go to the graph then.
  const opening = useDocument((document) => document.opening);
  useEffect(() => {
    if (!opening && document.activeElement === document.body) useView.getState().viewport?.focus();
  }, [opening]);
  useEffect(() => endAll(...features().flatMap(({ start }) => start?.() ?? [])), []);
  useEffect(() => {
    const ask = (event: BeforeUnloadEvent) => {
      if (useStudio.getState().dirty && !isKept() && !hasEarlyWork()) event.preventDefault();
      void flush();
    };
    // A browser may end a page that is not seen without a further word.
    const hide = () => void flush();
    return endAll(listen(window, { beforeunload: ask }), listen(document, { visibilitychange: hide }));
  }, []);
}

/** What the inspector has beside the code where nobody gave it a height, and the two lines between the panels, in px. */
const ROOM = 200;
const LINES = 2;

function Side() {
  const { sizes, folded: chosen } = useLayout();
  const { beside, selectedBefore } = useStage();
  const selects = useStudio(({ selection }) => selection.length > 0 && selection !== selectedBefore);
  // While something runs the arena has what only a part takes from it that is selected meanwhile.
  const folded = beside ? { ...chosen, arena: false, code: true, inspector: chosen.inspector || !selects } : chosen;
  // Inspector and code share what they have together, so that another part leaves the arena as it is; where one of them is
  // folded away the last open panel takes what the others leave.
  const last = !folded.arena ? "arena" : !folded.code ? "code" : "inspector";
  const both = !folded.inspector && !folded.code;
  const flex = (panel: "inspector" | "code" | "arena"): CSSProperties => {
    if (both && panel === "arena") {
      return { flex: `0 0 calc(100% - ${String((sizes.inspector || ROOM) + sizes.code + LINES)}px)` };
    }
    if (panel === last || (both && panel === "code")) return { flex: "1 0 0" };
    const size = panel === "arena" ? 0 : sizes[panel];
    return { flex: `0 1 ${size === 0 ? "auto" : `${String(size)}px`}` };
  };
  return (
    <div className="side column rigid slim" data-beside={beside} style={beside ? {} : { width: sizes.side }}>
      {folded.inspector ? null : (
        <section className="side-part side-inspector column" style={flex("inspector")} aria-label={t("view.inspector")}>
          <PanelSlot place="inspector" />
        </section>
      )}
      {folded.inspector || last === "inspector" ? null : (
        <Separator edge="inspector" label={t("view.inspector")} along="y" />
      )}
      {folded.code ? null : (
        <section className="side-part side-code column" style={flex("code")} aria-label={t("view.code")}>
          <PanelSlot place="code" />
        </section>
      )}
      {folded.code || last === "code" ? null : <Separator edge="code" label={t("view.code")} along="y" />}
      {folded.arena ? null : (
        <section className="side-part side-arena column" style={flex("arena")} aria-label={t("view.arena")}>
          <PanelSlot place="arena" />
        </section>
      )}
    </div>
  );
}

/** The sheet that is open. */
function Sheet() {
  const overlay = useDocument((document) => document.overlay);
  if (overlay === null) return null;
  return features().map(({ name, sheets }) => {
    const Open = sheets?.[overlay];
    return Open === undefined ? null : <Open key={name} />;
  });
}

function Studio() {
  useDocumentFlow();
  useKeys();
  const menus = useMenus();
  const { sizes, folded } = useLayout();
  const ahead = useDocument((document) => document.ahead);
  const ready = useDocument((document) => document.ready) || ahead;
  const opening = useDocument((document) => document.opening) || ahead;
  const covered = useDocument((document) => document.overlay === "new");
  const room = useMobileRoom((narrow) => narrow.room);
  const team = useTeam((state) => state.open || state.world);
  const { large, beside } = useStage();
  const side = beside || !(folded.inspector && folded.code && folded.arena);

  return (
    <div
      className="studio"
      data-room={room ?? "graph"}
      data-stage={large}
      aria-busy={opening}
      {...fileDrop((files) => {
        for (const { takeFiles } of features()) takeFiles?.(files);
      })}
    >
      <header className="head rigid relative">
        <div className="head-menu aligned relative">
          <Brand />
          <MenuBar menus={menus} />
          <Title />
        </div>
        <Toolbar menus={menus} />
        <TeamStop />
      </header>
      <Banner />
      <Slot name="banner" />
      <div className="middle" inert={covered}>
        {folded.palette ? null : (
          <nav className="parts-frame rigid flex slim" aria-label={t("app.parts")}>
            <div className="parts" style={{ width: sizes.palette }}>
              {ready ? <PanelSlot place="palette" /> : null}
            </div>
            <Separator edge="palette" label={t("view.palette")} along="x" />
          </nav>
        )}
        <main className="centre column grow relative" aria-label={t("app.canvas")}>
          {ready ? <Tabs /> : <div className="tabs rigid flex" />}
          <Slot name="above" />
          <div className="fill relative">
            <div
              className="canvas-panel cover"
              id="canvas-panel"
              role="tabpanel"
              aria-label={t("app.canvas")}
              data-covered={team}
            >
              {ready ? <PanelSlot place="graph" /> : null}
            </div>
            {ready ? features().map(({ name, tab }) => (tab === undefined ? null : <tab.Panel key={name} />)) : null}
          </div>
          <Slot name="below" />
          <Dock />
        </main>
        {side ? (
          <aside className="side-frame rigid flex slim" aria-label={t("app.side")}>
            <Separator edge="side" label={t("app.side")} along="x" sense={-1} />
            <Side />
          </aside>
        ) : null}
      </div>
      <footer className="bottom-bar rigid aligned" inert={covered}>
        <Slot name="bottom" />
      </footer>
      <Slot name="over-page" />
      <Sheet />
    </div>
  );
}

export function App() {
  const Instead = features().find((feature) => feature.Instead)?.Instead;
  if (Instead) return <Instead />;
  return (
    <>
      <Studio />
      <Slot name="after-page" />
    </>
  );
}

/** The sign of the studio: a way from one point to another. */
function Brand() {
  return (
    <svg className="brand rigid" width="16" height="16" viewBox="0 0 16 16" aria-hidden="true">
      <path d="M3 12.5C3 7 7 3.5 12.5 3.5" fill="none" stroke="currentColor" strokeWidth="2" strokeLinecap="round" />
      <circle cx="3" cy="13" r="2" fill="currentColor" />
      <circle cx="13" cy="3.5" r="2" fill="currentColor" />
    </svg>
  );
}
