/** The head of the teacher's page: its menus, and what is done with all pupils, or with those that the filter shows. */
import { classApi } from "../../../api/class";
import { t } from "../../../i18n/words";
import { Icon, useTheme } from "../../../theme";
import { download } from "../../../ui/download";
import { languageEntries, themeEntries } from "../../../ui/look-entries";
import { type MenuEntry, menuItem } from "../../../ui/menu-model";
import { MenuButton } from "../../../ui/MenuButton";
import { MarksTool } from "./MarksTool";
import type { SheetName } from "./Sheets";
import { act, freeze, useDesk } from "./store";

const MORE_PLACES = 50;
/** As many as a class can be told to take. */
const MOST_PLACES = 1000;

interface HeadProps {
  open: (sheet: SheetName) => void;
  /** Those that the filter shows; null: all. */
  folders: readonly string[] | null;
  here: number;
  away: number;
}

function useEntries(open: (sheet: SheetName) => void): { menus: [string, string, MenuEntry[]][] } {
  const { news, seen } = useDesk();
  const anyFrozen = [...seen.values()].some(({ pupil }) => pupil.frozen);
  const choice = useTheme((theme) => theme.choice);
  const coded = news?.code !== "";
  const places = Math.min((news?.places ?? 0) + MORE_PLACES, MOST_PLACES);
  const full = news === null || news.places >= MOST_PLACES;
  const ofClass: MenuEntry[] = [
    menuItem("class-new-code", t("teacher.new-code"), null, () => act(classApi.setCode(true))),
    menuItem("class-revoke", t("teacher.revoke"), null, () => act(classApi.setCode(false)), !coded),
    menuItem("class-thaw", t("teacher.thaw"), null, () => freeze(false, null), news?.frozen !== true && !anyFrozen),
    { kind: "line", id: "class-places-line" },
    menuItem("class-places", t("teacher.more-places", { places }), null, () => act(classApi.setPlaces(places)), full),
    menuItem("class-remove-idle", t("teacher.remove-idle"), null, () => act(classApi.removeIdle())),
    { kind: "line", id: "class-line" },
    menuItem("class-table", t("teacher.table"), null, () =>
      act(classApi.table().then(({ bytes }) => download("class.csv", new Uint8Array(bytes), "text/csv"))),
    ),
    menuItem("class-log", t("teacher.log"), null, () => open("log")),
  ];
  const view: MenuEntry[] = [...languageEntries(), { kind: "line", id: "view-line" }, ...themeEntries(choice)];
  return {
    menus: [
      ["teacher-class", t("teacher.menu-class"), ofClass],
      ["teacher-view", t("teacher.menu-view"), view],
    ],
  };
}

function collect(folders: readonly string[] | null, name: string): void {
  act(classApi.collect(folders).then(({ bytes }) => download(`${name}.zip`, new Uint8Array(bytes), "application/zip")));
}

function openGrades(): void {
  act(classApi.grades().then(({ bytes }) => download("grades.html", new Uint8Array(bytes), "text/html")));
}

function GradeTool({ folders }: { folders: readonly string[] | null }) {
  const news = useDesk((desk) => desk.news);
  const grading = news?.grading ?? null;
  if (grading !== null && grading.page === "" && grading.done < grading.total) {
    return (
      <span className="tool-named class-grading muted nowrap medium gap-m relative" role="status">
        {t("teacher.grading", { done: grading.done, total: grading.total })}
      </span>
    );
  }
  return (
    <>
      <button
        type="button"
        className="tool tool-named rigid nowrap medium gap-m relative"
        data-testid="grade"
        disabled={news?.exercise === ""}
        onClick={() => act(classApi.grade(folders))}
      >
        <Icon name="list-checks" size={18} />
        {folders === null ? t("teacher.grade") : t("teacher.grade-some", { count: folders.length })}
      </button>
      {grading !== null && grading.page !== "" ? (
        <button
          type="button"
          className="tool tool-named rigid nowrap medium gap-m relative"
          data-testid="grades"
          onClick={openGrades}
        >
          <Icon name="file" size={18} />
          {t("teacher.grades")}
        </button>
      ) : null}
    </>
  );
}

/** Freezes those that the filter shows, or all; lets them go on once they are frozen. */
function FreezeTool({ folders }: { folders: readonly string[] | null }) {
  const { news, seen } = useDesk();
  const frozen =
    folders === null
      ? news?.frozen === true
      : folders.length > 0 && folders.every((folder) => seen.get(folder)?.pupil.frozen === true);
  const count = folders?.length ?? 0;
  return (
    <button
      type="button"
      className="tool tool-named rigid nowrap medium gap-m relative"
      data-testid="freeze"
      aria-pressed={frozen}
      disabled={folders !== null && count === 0}
      onClick={() => freeze(!frozen, folders)}
    >
      <Icon name="snowflake" size={18} />
      {folders === null
        ? t(frozen ? "teacher.frozen" : "teacher.freeze")
        : t(frozen ? "teacher.frozen-some" : "teacher.freeze-some", { count })}
    </button>
  );
}

export function Head({ open, folders, here, away }: HeadProps) {
  const news = useDesk((desk) => desk.news);
  const { menus } = useEntries(open);
  const some = folders === null ? null : folders.length;
  return (
    <header className="class-head rigid">
      <div className="class-head-menu aligned relative">
        {menus.map(([id, label, entries]) => (
          <MenuButton
            key={id}
            id={id}
            label={label}
            entries={entries}
            className="menubar-title small-text nowrap medium focus-inside"
          >
            {label}
          </MenuButton>
        ))}
        <h1 className="small-text ellipsis" dir="auto">
          {news?.name ?? ""}
        </h1>
      </div>
      <div className="class-tools row wrap gap-xs" role="toolbar" aria-label={t("teacher.menu-class")}>
        <button
          type="button"
          className="run-button bold rigid inline-row ink justify-centre"
          data-testid="send"
          onClick={() => open("send")}
        >
          <Icon name="send" size={18} />
          {some === null ? t("teacher.send") : t("teacher.send-some", { count: some })}
        </button>
        <FreezeTool folders={folders} />
        <button
          type="button"
          className="tool tool-named rigid nowrap medium gap-m relative"
          data-testid="collect"
          onClick={() => collect(folders, news?.folder ?? "class")}
        >
          <Icon name="folder-down" size={18} />
          {some === null ? t("teacher.collect") : t("teacher.collect-some", { count: some })}
        </button>
        <GradeTool folders={folders} />
        <MarksTool />
        <span className="tool-line rigid" />
        <button
          type="button"
          className="tool tool-named rigid nowrap medium gap-m relative"
          data-testid="add"
          onClick={() => open("add")}
        >
          <Icon name="user-plus" size={18} />
          {t("teacher.add")}
        </button>
        <p className="class-there row to-end gap-s" data-testid="class-there">
          <Icon name="circle-dot" size={14} />
          {t("teacher.here", { count: here })}
          <Icon name="circle-dashed" size={14} />
          {t("teacher.away", { count: away })}
        </p>
      </div>
    </header>
  );
}
