/** French for the outline, the announcements and the help for a part. */
import type { Table } from "./words";

export const REACH_FR = {
  "reach.undone": "Annulé : {what}",
  "reach.redone": "Rétabli : {what}",

  "outline.title": "Plan",
  "outline.of": "Plan de {name}",
  "outline.close": "Fermer le plan",

  "part-help.title": "Aide sur une pièce",
  "part-help.how": "Choisissez une pièce dans le graphe ou dans la liste des pièces, puis appuyez sur F1.",
  "part-help.range": "Un nombre entier de {min} à {max}, d'abord {first}",
  "part-help.switch": "Vrai ou faux",
  "part-help.text": "Un texte",
  "part-help.condition": "Un test se place ici.",
  "part-help.value": "Une valeur se place ici.",
  "part-help.action": "Une action du robot se place ici.",
  "part-help.body": "D'autres pièces se placent dedans.",

  "help.part": "Aide sur la pièce choisie",
  "help.keys-part": "Aide sur la pièce choisie",
  "help.keys-outline": "Plan du programme, en mots",
} satisfies Table;
