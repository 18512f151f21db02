/** The parts that a program is made of, and the variables of the mission. */
import { t } from "../../i18n/words";
import type { Feature } from "../../session/features";
import { keyFor } from "../../session/key-table";
import { newVariable } from "../../session/variables";
import { menuItem } from "../../ui/menu-model";
import { Palette } from "./Palette";

export const palette: Feature = {
  name: "palette",
  panels: { palette: Palette },
  commands: { variable: () => newVariable() },
  useMenu: () => ({
    variable: [menuItem("program-variable", t("variable.new-dots"), keyFor.page("variable"), () => newVariable())],
  }),
};
