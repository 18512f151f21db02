/** The missions of the workspace and the examples, and a file of this computer. */
import { useRef } from "react";

import type { MissionEntry } from "../../api/generated";
import { Gallery } from "./Gallery";
import { Jumps } from "./Jumps";
import { Icon } from "../../theme";
import { Doors } from "../../components/Doors";
import { languageInUse, t } from "../../i18n/words";
import { closeOverlay, show, shownName, useDocument } from "../../session/document";
import { openFromComputer, openLeft, openPath } from "../../session/open-requests";
import { useOpenable } from "./missions";
import { Button } from "../../ui/Button";
import { Sheet } from "../../ui/Sheet";

function open(entry: MissionEntry): void {
  show(null);
  openPath(entry.path);
}

interface EntryProps {
  entry: { path: string; problem: string };
  icon: "file" | "clapperboard";
  title: string;
}

/** A file of the folder; one that cannot be opened says why. */
function Entry({ entry: { path, problem }, icon, title }: EntryProps) {
  const choose = () => {
    show(null);
    openPath(path);
  };
  return (
    <li>
      <button
        type="button"
        className="open-entry row start-text gap-xl hover"
        data-path={path}
        disabled={problem !== ""}
        onClick={choose}
      >
        <Icon name={problem === "" ? icon : "triangle-alert"} size={18} />
        <span className="open-title ellipsis medium" dir="auto" title={title}>
          {title}
        </span>
        {problem === "" ? null : <span className="muted small-text slim">{problem}</span>}
        <span className="open-path ellipsis muted small-text slim" dir="auto" title={path}>
          {path}
        </span>
      </button>
    </li>
  );
}

/** All lists at once: one that came later would push what is below it away from under a pointer. */
function Lists() {
  const openable = useOpenable();
  const workspace = useDocument((document) => document.session?.workspace ?? "");
  if (openable === null) return <p className="sheet-note muted small-text">{t("open.loading")}</p>;
  const { left, missions, recordings } = openable;
  const own = missions.filter((entry) => entry.example === null);
  const examples = missions.filter((entry) => entry.example !== null);
  return (
    <>
      {left.length === 0 ? null : (
        <>
          <h3>{t("journal.list")}</h3>
          <ul data-testid="open-left">
            {left.map(({ journal, path, name, modified, problem }) => (
              <li key={journal}>
                <button
                  type="button"
                  className="open-entry row start-text gap-xl hover"
                  disabled={problem !== ""}
                  onClick={() => {
                    show(null);
                    openLeft(journal);
                  }}
                >
                  <Icon name={problem === "" ? "file" : "triangle-alert"} size={18} />
                  <span className="open-title ellipsis medium">{problem || shownName(name)}</span>
                  <span className="open-path ellipsis muted small-text slim">
                    {path} {new Date(modified).toLocaleString(languageInUse())}
                  </span>
                </button>
              </li>
            ))}
          </ul>
        </>
      )}
      <h3>{t("open.workspace", { folder: workspace })}</h3>
      {own.length === 0 ? <p className="sheet-note muted small-text">{t("open.workspace-empty")}</p> : null}
      <ul>
        {own.map((entry) => (
          <Entry key={entry.path} entry={entry} icon="file" title={entry.title || entry.name} />
        ))}
      </ul>
      {recordings.length === 0 ? null : (
        <>
          <h3>{t("recording.list", { folder: workspace })}</h3>
          <ul data-testid="open-recordings">
            {recordings.map((entry) => (
              <Entry key={entry.path} entry={entry} icon="clapperboard" title={entry.name} />
            ))}
          </ul>
        </>
      )}
      {examples.length === 0 ? null : <h3>{t("open.examples")}</h3>}
      {examples.length === 0 ? null : <Gallery examples={examples} open={open} />}
    </>
  );
}

export function OpenSheet() {
  const chooser = useRef<HTMLInputElement>(null);
  return (
    <Sheet title={t("open.title")} testId="open-dialog" wide onClose={closeOverlay}>
      <div className="open-lists">
        <Doors />
        <Jumps />
        <Lists />
      </div>
      <div className="sheet-foot flex gap-m justify-end">
        <input
          ref={chooser}
          className="only-spoken"
          type="file"
          accept=".krt,.krtrace,.xml,.svg,.png,.pdf,.hex,.uf2"
          tabIndex={-1}
          aria-hidden="true"
          data-testid="open-file"
          onChange={(event) => {
            const file = event.target.files?.[0];
            if (file === undefined) return;
            show(null);
            openFromComputer(file);
          }}
        />
        <Button icon="upload" onClick={() => chooser.current?.click()}>
          {t("open.computer")}
        </Button>
        <Button onClick={() => show(null)}>{t("open.cancel")}</Button>
      </div>
    </Sheet>
  );
}
