/**
 * The theme: light, dark, or as the system does.
 *
 * The choice lives in localStorage; what is shown is always written on the root element as data-theme, so that CSS and
 * the arena's canvas read one thing. Colours themselves are in tokens.css.
 */
import { create } from "zustand";

export type ThemeChoice = "light" | "dark" | "system";
export type Theme = "light" | "dark";

const KEY = "kitrobot.theme";

function systemTheme(): Theme {
  return typeof matchMedia === "function" && matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

function remembered(): ThemeChoice {
  try {
    const value = localStorage.getItem(KEY);
    return value === "light" || value === "dark" ? value : "system";
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
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      if (useTheme.getState().choice === "system") useTheme.setState({ theme: systemTheme() });
    });
  }
}

/** The value of a CSS variable as it stands, for drawing on a canvas. */
export function token(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
