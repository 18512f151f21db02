/** The theme's interface: icons, tiles, the choice of light or dark, colours for drawing. */
export { Icon, loadIcons } from "./Icon";
export { fontOf } from "./font";
export { type Theme, type ThemeChoice, installTheme, token, useTheme } from "./theme";
export { type Category, Tile } from "./Tile";
