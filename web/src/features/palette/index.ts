/** The parts that a program is made of, and the variables of the mission. */
import { t } from "../../i18n/words";
import type { Feature } from "../../session/features";
import { keyFor, type PageKey } from "../../session/key-table";
import { newVariable } from "../../session/variables";
import { menuItem } from "../../ui/menu-model";
import { Palette } from "./Palette";

const KEYS = {
  variable: { chords: ["Alt+V"], says: "variable.new", typing: true, run: () => newVariable() },
} satisfies Record<string, PageKey>;

export const palette: Feature = {
  name: "palette",
  panels: { palette: Palette },
  keys: KEYS,
  useMenu: () => ({
    variable: [menuItem("program-variable", t("variable.new-dots"), keyFor.page(KEYS.variable), () => newVariable())],
  }),
};
