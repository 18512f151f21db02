/** The button of marks: they go out in the form of a gradebook, and the gradebook's list of pupils comes in. */
import { classApi, type Gradebook, GRADEBOOKS } from "../../../api/class";
import { t } from "../../../i18n/words";
import { Icon } from "../../../theme";
import { download } from "../../../ui/download";
import { type MenuEntry, menuItem } from "../../../ui/menu-model";
import { MenuButton } from "../../../ui/MenuButton";
import { act, say } from "./store";

async function save(gradebook: Gradebook): Promise<void> {
  const { name, text, exercises, listed, unlisted } = await classApi.marks(gradebook);
  if (exercises === 0) {
    say(t("teacher.marks-none"), t("teacher.marks-none-help"));
    return;
  }
  download(name, text, "text/csv");
  const missing = unlisted.length === 0 ? "" : t("teacher.marks-unlisted", { names: unlisted.join(", ") });
  const help = listed || gradebook === "sheet" ? missing : t("teacher.marks-no-list");
  say(t("teacher.marks-saved", { file: name, count: exercises }), help);
}

async function keep(file: File): Promise<void> {
  const { pupils, unlisted } = await classApi.keepGradebook(await file.arrayBuffer());
  const missing = unlisted.length === 0 ? "" : t("teacher.gradebook-unlisted", { names: unlisted.join(", ") });
  say(t("teacher.gradebook-kept", { count: pupils }), missing);
}

function chooseList(): void {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = ".csv,.tsv,.txt,text/csv";
  input.addEventListener("change", () => takeList([...(input.files ?? [])]));
  input.click();
}

/** Keeps the gradebook's list that was chosen, or dropped on the teacher's page. */
export function takeList(files: readonly File[]): void {
  const [file] = files;
  if (file === undefined || files.length > 1) say(t("teacher.gradebook-one"));
  else act(keep(file));
}

/** The marks of the class as CSV, in the form that a gradebook imports, and the list that the gradebook exports. */
export function MarksTool() {
  const entries: MenuEntry[] = [
    ...GRADEBOOKS.map((one) => menuItem(`marks-${one}`, t(`teacher.marks-${one}`), null, () => act(save(one)))),
    { kind: "line", id: "marks-line" },
    menuItem("gradebook-list", t("teacher.gradebook"), null, chooseList),
  ];
  return (
    <MenuButton
      id="class-marks"
      label={t("teacher.marks")}
      className="tool tool-named rigid nowrap medium gap-m relative"
      entries={entries}
    >
      <Icon name="clipboard-check" size={18} />
      {t("teacher.marks")}
    </MenuButton>
  );
}
