/**
 * The theme: light, dark, high contrast, or as the system does.
 *
 * The choice lives in localStorage; what is shown is always written on the root element as data-theme, so that CSS and
 * the arena's canvas read one thing. Colours themselves are in tokens.css.
 */
import { create } from "zustand";

export type Theme = "light" | "dark" | "contrast";
export type ThemeChoice = Theme | "system";

const KEY = "kitrobot.theme";

const MORE_CONTRAST = "(prefers-contrast: more)";
const DARK = "(prefers-color-scheme: dark)";

function systemTheme(): Theme {
  if (typeof matchMedia !== "function") return "light";
  return matchMedia(MORE_CONTRAST).matches ? "contrast" : matchMedia(DARK).matches ? "dark" : "light";
}

function remembered(): ThemeChoice {
  try {
    const value = localStorage.getItem(KEY);
    return value === "light" || value === "dark" || value === "contrast" ? value : "system";
  } catch {
    return "system";
  }
}

interface ThemeState {
  choice: ThemeChoice;
  theme: Theme;
  choose: (choice: ThemeChoice) => void;
}

export const useTheme = create<ThemeState>((set) => {
  const choice = remembered();
  return {
    choice,
    theme: choice === "system" ? systemTheme() : choice,
    choose: (next) => {
      try {
        localStorage.setItem(KEY, next);
      } catch {
        // A browser without storage keeps the choice until the page is closed.
      }
      set({ choice: next, theme: next === "system" ? systemTheme() : next });
    },
  };
});

/** Writes the theme on the page now and whenever the choice or the system changes. */
export function installTheme(): void {
  const write = ({ theme }: ThemeState) => {
    document.documentElement.dataset["theme"] = theme;
  };
  write(useTheme.getState());
  useTheme.subscribe(write);
  if (typeof matchMedia === "function") {
    for (const wish of [MORE_CONTRAST, DARK]) {
      matchMedia(wish).addEventListener("change", () => {
        if (useTheme.getState().choice === "system") useTheme.setState({ theme: systemTheme() });
      });
    }
  }
}

/** The value of a CSS variable as it stands, for drawing on a canvas. */
export function token(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
