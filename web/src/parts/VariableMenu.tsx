/** The menu of a variable in the palette: by the right button, the menu key, or a finger that rests. */
import { FloatingMenu } from "../shell/FloatingMenu";
import type { MenuEntry } from "../shell/menu-model";
import { t } from "../words/words";
import { editVariable, newVariable, renameVariable, takeAway, useVariables } from "./variables";

export function VariableMenu() {
  const menu = useVariables((state) => state.menu);
  if (menu === null) return null;
  return <Open key={`${menu.name} ${String(menu.y)}`} {...menu} />;
}

function Open({ robot, name, x, y }: { robot: string; name: string; x: number; y: number }) {
  const close = () => useVariables.setState({ menu: null });
  const of = { robot, name };
  const entries: MenuEntry[] = [
    { kind: "item", id: "variable-rename", label: t("variable.rename"), keys: "F2", run: () => renameVariable(of) },
    { kind: "item", id: "variable-edit", label: t("variable.edit"), run: () => editVariable(of) },
    { kind: "item", id: "variable-remove", label: t("variable.remove"), keys: "Del", run: () => takeAway(of) },
    { kind: "line", id: "variable-1" },
    { kind: "item", id: "variable-new", label: t("variable.new-dots"), run: () => newVariable() },
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
