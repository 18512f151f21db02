/** Entries of a menu for how the page looks and which language it speaks. */
import { useLanguage } from "../i18n/language";
import { LANGUAGES } from "../i18n/languages";
import { type Language, languageInUse, t } from "../i18n/words";
import { type ThemeChoice, useTheme } from "../theme";
import { type MenuItem, menuRadio } from "./menu-model";

export const THEMES: readonly ThemeChoice[] = ["light", "dark", "contrast", "system"];
export const SPOKEN = Object.keys(LANGUAGES) as Language[];

/** `choice`: the theme that is chosen. */
export function themeEntries(choice: ThemeChoice): MenuItem[] {
  return THEMES.map((theme) =>
    menuRadio(`view-${theme}`, t(`view.${theme}`), theme === choice, () => useTheme.getState().choose(theme)),
  );
}

export function languageEntries(): MenuItem[] {
  return SPOKEN.map((language) =>
    menuRadio(`view-${language}`, LANGUAGES[language].name, language === languageInUse(), () =>
      useLanguage.getState().choose(language),
    ),
  );
}
