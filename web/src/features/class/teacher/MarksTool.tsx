/** The marks of the class as CSV, in the form that a gradebook imports. */
import { classApi, type Gradebook, GRADEBOOKS } from "../../../api/class";
import { t } from "../../../i18n/words";
import { Icon } from "../../../theme";
import { download } from "../../../ui/download";
import { menuItem } from "../../../ui/menu-model";
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

export function MarksTool() {
  const entries = GRADEBOOKS.map((one) =>
    menuItem(`marks-${one}`, t(`teacher.marks-${one}`), null, () => act(save(one))),
  );
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
