/** French for the outline, the announcements and the help for a part. */
import type { Table } from "./words";

export const ACCESSIBILITY_FR = {
  "reach.undone": "Annulé : {what}",
  "reach.redone": "Rétabli : {what}",
  "reach.selected": "Choisi : {what}",

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

  "help.keys-save-as": "Enregistrer sous un autre nom",
  "help.keys-room": "Partie suivante de la page, partie précédente",
  "help.keys-program": "Programme suivant, programme précédent",
  "help.keys-program-move": "Déplacer l'onglet du programme",
  "help.keys-rename": "Renommer le programme",
  "help.keys-arc": "Choisir une flèche qui part de la pièce : vers l'intérieur, puis la suite",
  "help.keys-extend": "Choisir aussi la pièce suivante",
  "help.keys-note": "Écrire une note sur la pièce",
  "help.keys-move": "Monter ou descendre les pièces choisies",
  "help.keys-nothing": "Ne rien choisir",
  "help.keys-pan": "Déplacer la vue",
  "help.keys-hand": "Maintenir un bouton de la carte, ou la secouer",
  "help.keys-robot": "Robot suivant, robot précédent",
  "help.keys-lists": "Dans les listes, onglets et menus",
  "help.keys-tabs": "D'un onglet à l'autre",
  "help.keys-tab-delete": "Supprimer le programme de l'onglet",
  "help.keys-tree": "Parcourir la liste des pièces, plier et déplier",
  "help.keys-tree-add": "Ajouter la pièce, choisir l'entrée",
  "help.keys-lines": "Déplacer la ligne entre deux panneaux, un curseur",
  "help.keys-paths": "Par les menus",
  "help.keys-paths-how":
    "Alt va aux menus ; la première lettre ou les flèches en ouvrent un, lettres et flèches vont à une entrée, Entrée la choisit.",
  "program.next": "Programme suivant",
  "program.previous": "Programme précédent",
  "program.later": "Avancer l'onglet",
  "program.earlier": "Reculer l'onglet",
} satisfies Table;
