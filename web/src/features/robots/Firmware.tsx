/**
 * Which MicroPython a kit needs and whether the board has it; and MicroPython for a board that shows itself as a drive.
 *
 * Nothing is fetched from the network: the page of the maker is named, and a file that the reader has is copied.
 */
import { useEffect, useRef, useState } from "react";

import { firmwareApi } from "../../api/firmware";
import type { Drive, KitEntry } from "../../api/generated";
import { type Failure, whyRefused } from "../../api/refusal";
import { Said } from "../../i18n/Said";
import { t } from "../../i18n/words";
import { Icon } from "../../theme";
import { Row } from "../../ui/Row";
import { Select } from "../../ui/Select";
import { useBoards } from "./boards";
import { Act, TroubleBox } from "./parts";

interface NeedProps {
  kit: KitEntry;
  /** The version that the board has, "" where that is not known. */
  has: string;
  /** The page with MicroPython for the board, "" where none is known. */
  page: string;
}

/** The least version that a kit's file names, and whether the board has it. */
export function FirmwareNeed({ kit, has, page }: NeedProps) {
  const least = kit.micropython;
  if (least === "") return null;
  const older = has !== "" && isOlder(has, least);
  const href = kit.firmware || page || "https://micropython.org/download/";
  return (
    <p
      className={older ? "robot-need muted small-text is-older flex gap-s" : "robot-need muted small-text flex gap-s"}
      role={older ? "alert" : undefined}
      data-testid="robot-need"
      data-met={has === "" ? "unknown" : older ? "no" : "yes"}
    >
      <Icon name={older ? "triangle-alert" : "info"} size={14} />
      <span>
        {has === ""
          ? t("firmware.needs", { least })
          : t(older ? "firmware.older" : "firmware.met", { least, version: has })}{" "}
        {has === "" || older ? (
          <a className="robot-link start-text medium" href={href} target="_blank" rel="noreferrer">
            {t("boards.firmware")}
          </a>
        ) : null}
      </span>
    </p>
  );
}

/** A board in its bootloader: which drive it shows, and the file that is copied there. */
function Flashing() {
  const [drives, setDrives] = useState<readonly Drive[] | null>(null);
  const [page, setPage] = useState("");
  const [wrong, setWrong] = useState<Failure | null>(null);
  const [done, setDone] = useState("");
  const [chosen, setChosen] = useState("");
  const [file, setFile] = useState<File | null>(null);
  const [busy, setBusy] = useState(false);

  const fail = (cause: unknown) => setWrong(whyRefused(cause));
  const look = () => {
    firmwareApi.look().then((found) => {
      setWrong(null);
      setDrives(found.drives);
      setPage(found.page);
    }, fail);
  };
  useEffect(look, []);
  const place = useRef<HTMLDivElement>(null);
  const looked = drives !== null;
  useEffect(() => {
    place.current?.scrollIntoView({ block: "nearest" });
  }, [looked]);
  const drive = drives?.find(({ folder }) => folder === chosen) ?? drives?.[0];
  const copy = () => {
    if (file === null || drive === undefined) return;
    setBusy(true);
    setWrong(null);
    setDone("");
    file
      .arrayBuffer()
      .then((bytes) => firmwareApi.flash(file.name, drive.folder, bytes))
      .then(({ board, micropython }) => {
        setDone(t(micropython === "" ? "firmware.done-other" : "firmware.done", { board, version: micropython }));
        setFile(null);
        look();
      }, fail)
      .finally(() => setBusy(false));
  };
  return (
    <div ref={place} className="robot-flash gap-m" data-testid="firmware">
      <p className="robots-note muted">
        {t("firmware.about")}{" "}
        {page === "" ? null : (
          <a className="robot-link start-text medium" href={page} target="_blank" rel="noreferrer">
            {t("firmware.page")}
          </a>
        )}
      </p>
      {drives === null ? null : drives.length === 0 ? (
        <p className="robots-note muted" data-testid="firmware-none">
          {t("firmware.none")}
        </p>
      ) : (
        <>
          <Row label={t("firmware.drive")} className="robot-program muted below">
            <Select
              className="field small-field"
              label={t("firmware.drive")}
              testId="firmware-drive"
              disabled={busy}
              value={drive?.folder ?? ""}
              options={drives.map(({ folder, board, chip }) => [
                folder,
                [board || folder, chip].filter((word) => word !== "").join(" · "),
              ])}
              keep={setChosen}
            />
          </Row>
          <Row label={t("firmware.file")} className="robot-program muted below">
            <input
              key={done}
              type="file"
              accept=".uf2"
              data-testid="firmware-file"
              disabled={busy}
              onChange={(event) => setFile(event.target.files?.[0] ?? null)}
            />
          </Row>
        </>
      )}
      {wrong === null ? null : <TroubleBox said={wrong} testId="firmware-trouble" />}
      {done === "" ? null : (
        <p role="status" data-testid="firmware-done">
          <Said text={done} />
        </p>
      )}
      <div className="robot-acts row wrap slim">
        {drives !== null && drives.length > 0 ? (
          <Act
            ink
            icon="upload"
            label={t(busy ? "firmware.copying" : "firmware.copy")}
            testId="firmware-copy"
            disabled={busy || file === null}
            onPress={copy}
          />
        ) : null}
        <Act icon="refresh-cw" label={t("firmware.look")} testId="firmware-look" disabled={busy} onPress={look} />
      </div>
    </div>
  );
}

/** A line of the panel that opens into it. */
export function FirmwarePart() {
  const you = useBoards((state) => state.you);
  const [open, setOpen] = useState(false);
  if (you === "") return null;
  return (
    <details className="robot-firmware" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary data-testid="firmware-open">{t("firmware.title")}</summary>
      {open ? <Flashing /> : null}
    </details>
  );
}

/** Versions of MicroPython, as "1.20", "1.24.1" or, before it was released, "1.25.0-preview". */
const NUMBERS = 3;

/** Its numbers, then whether it is a release and no preview of that. */
function orderOf(version: string): number[] {
  const [numbers = "", level] = version.split("-");
  const found = numbers.split(".").map(Number);
  return [...Array.from({ length: NUMBERS }, (_, at) => found[at] ?? 0), level === undefined ? 1 : 0];
}

/** Whether a version is older than the least one. */
export function isOlder(version: string, least: string): boolean {
  const has = orderOf(version);
  const wanted = orderOf(least);
  const at = wanted.findIndex((number, place) => number !== has[place]);
  return at >= 0 && (has[at] ?? 0) < (wanted[at] ?? 0);
}
