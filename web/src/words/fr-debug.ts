/** Breakpoints and the watch, in French. */
import type { Table } from "./words";

export const DEBUG_FR = {
  "debug.breakpoint": "Pause ici",
  "debug.breakpoint-off": "Pause ici, désactivée",
  "debug.toggle": "Faire une pause ici, ou non",
  "debug.says-when": "quand {when}",
  "debug.says-hits": "à partir du passage {hits}",
  "debug.when": "Seulement quand",
  "debug.hits": "À partir du passage",
  "debug.who": "Pour",
  "debug.every": "Seulement quand tous sont ici",
  "debug.paused-at": "En pause : {agent} est ici, passage {visit}",
  "debug.watch": "Observer",
  "debug.watch-close": "Fermer l'observation",
  "debug.watch-nothing":
    "Appuyez sur Lancer : vous verrez ici ce que disent les variables et les capteurs du robot, et pourrez le changer.",
  "debug.agent": "Quel robot",
  "debug.name": "Nom",
  "debug.value": "Valeur",
  "debug.plot": "Au fil du temps",
  "debug.plot-of": "{name} au fil du temps",
  "debug.yes": "oui",
  "debug.no": "non",
  "debug.release": "Relâcher",
  "debug.release-help":
    "Vous avez mis cette valeur à la place de ce que mesure le capteur. Relâchez, et il mesure de nouveau.",
} satisfies Table;
