/** The mission's name and whether it is on disk as it stands; the browser's title says the same. */
import { useEffect } from "react";

import { t } from "../i18n/words";
import { useStudio } from "../model/studio";
import { isOther, useDisk } from "../session/disk";
import { shownName, useDocument } from "../session/document";
import { useLink } from "../session/journal";
import { isFromRecording } from "../session/recordings";

export function Title() {
  const file = useStudio((studio) => studio.file);
  const dirty = useStudio((studio) => studio.dirty);
  const ready = useDocument(({ ready, ahead }) => ready || ahead);
  const others = useDisk((disk) => (disk.path === file.path ? disk.others : 0));
  const lost = useLink((link) => link.connected === false);
  const kept = useLink((link) => link.kept);
  const changed = useDisk((disk) => isOther(disk, file));
  const name = shownName(file.name);
  useEffect(() => {
    document.title = ready ? `${dirty ? "• " : ""}${name} · ${t("app.name")}` : t("app.name");
  }, [name, dirty, ready]);
  if (!ready) return null;
  const state = !kept
    ? t("file.only-here")
    : dirty
      ? t(lost ? "file.not-kept" : "file.not-saved")
      : file.path === ""
        ? t("file.new-program")
        : file.path.startsWith("example:")
          ? t("file.example")
          : isFromRecording(file.path)
            ? t("recording.title")
            : t(lost ? "file.unknown" : changed ? "file.changed" : "file.saved");
  return (
    <div className="title muted small-text flex nowrap gap-m justify-centre" data-testid="title">
      <h1 title={name} dir="auto">
        {name}
      </h1>
      <span aria-hidden="true">·</span>
      <span data-testid="saved-state" title={state}>
        {state}
      </span>
      {others > 0 ? (
        <>
          <span aria-hidden="true">·</span>
          <span role="status" title={t("disk.also-open-help")} data-testid="also-open">
            {t("disk.also-open")}
          </span>
        </>
      ) : null}
    </div>
  );
}
