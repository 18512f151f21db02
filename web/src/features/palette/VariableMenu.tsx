/** The menu of a variable in the palette: by the right button, the menu key, or a finger that rests. */
import { t } from "../../i18n/words";
import {
  editVariable,
  newVariable,
  openVariableMenu,
  renameVariable,
  takeAway,
  useVariables,
} from "../../session/variables";
import { FloatingMenu } from "../../ui/FloatingMenu";
import { type MenuEntry, menuItem } from "../../ui/menu-model";

export function VariableMenu() {
  const menu = useVariables((state) => state.menu);
  if (menu === null) return null;
  return <Open key={`${menu.name} ${String(menu.y)}`} {...menu} />;
}

function Open({ robot, name, x, y }: { robot: string; name: string; x: number; y: number }) {
  const close = () => openVariableMenu(null);
  const of = { robot, name };
  const entries: MenuEntry[] = [
    menuItem("variable-rename", t("variable.rename"), "F2", () => renameVariable(of)),
    menuItem("variable-edit", t("variable.edit"), null, () => editVariable(of)),
    menuItem("variable-remove", t("variable.remove"), "Del", () => takeAway(of)),
    { kind: "line", id: "variable-1" },
    menuItem("variable-new", t("variable.new-dots"), null, () => newVariable()),
  ];
  return (
    <FloatingMenu
      id="variable"
      label={t("variable.menu", { name })}
      at={{ x, y }}
      entries={entries}
      onLeave={close}
      onClose={() => {
        close();
        document.querySelector<HTMLElement>(`[data-row="${CSS.escape(`object variable ${name}`)}"]`)?.focus();
      }}
    />
  );
}
