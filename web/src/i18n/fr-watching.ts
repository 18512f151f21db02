/** Runs that another window steers, in French. */
import type { Table } from "./words";

export const WATCHING_FR = {
  "watching.offer": "Cette mission tourne dans une autre fenêtre.",
  "watching.watch": "Regarder",
  "watching.on": "Vous regardez une exécution qu’une autre fenêtre dirige ; STOP ne fait ici que cesser de regarder.",
  "watching.another":
    "Ce qui tourne là-bas n’est pas ce qui est ouvert ici : certaines pièces ne s’allumeront peut-être pas.",
  "watching.leave": "Ne plus regarder",
} satisfies Table;
