/**
 * Languages by the name that their readers give them, and the way they run.
 *
 * Written by `python tools/api_types.py` from the list in `src/kitrobot/translation/languages.py`: change that instead.
 */
export const LANGUAGES = {
  en: { name: "English", dir: "ltr" },
  es: { name: "Español", dir: "ltr" },
  fr: { name: "Français", dir: "ltr" },
  pt: { name: "Português", dir: "ltr" },
  ur: { name: "اردو", dir: "rtl" },
} as const;
