/** French for unsaved work that comes back, files that change on disk, and missions open twice. */
import type { Table } from "./words";

export const JOURNAL_FR = {
  "journal.back": "Votre travail non enregistré sur {name} est de retour.",
  "journal.back-help": "Annuler fonctionne comme avant.",
  "journal.back-damaged": "Le journal était abîmé : les derniers pas manquent peut-être.",
  "journal.back-steps":
    "Tout votre travail est là, mais le journal était abîmé : les étapes plus anciennes ne peuvent plus être annulées.",
  "journal.failed-help": "Enregistrez votre travail maintenant : dans le fichier, il est en sûreté.",
  "journal.discard": "L'abandonner",
  "journal.left": "Du travail non enregistré sur {name} est gardé.",
  "journal.open": "L'ouvrir",
  "journal.leave-help":
    "Continuez : elles sont gardées dans le journal, et Fichier → Ouvrir les montre sous « Travail non enregistré ».",
  "journal.again-help": "Ouvrir le fichier encore une fois les jette.",
  "journal.not-kept":
    "Les changements de {name} ne peuvent pas être gardés dans le journal en ce moment : sans enregistrer, ils seraient perdus.",
  "journal.left-help": "Fichier → Ouvrir le montre sous « Travail non enregistré ».",
  "journal.gone": "Ce travail est ouvert dans une autre fenêtre, ou a été jeté.",
  "journal.list": "Travail non enregistré",
  "journal.later": "Plus tard",
  "journal.failed": "Vos changements ne sont pas mis à l'abri en ce moment.",
  "file.not-kept": "non enregistré, non gardé : pas de connexion",
  "file.unknown": "pas de connexion avec le studio",
  "file.changed": "changé sur le disque",
  "journal.returned": "Le studio a redémarré, et cette page continue avec lui.",
  "journal.returned-help": "Vos changements sont gardés.",
  "journal.stranger": "Quelqu'un d'autre est à la place du studio de cette page.",
  "journal.stranger-help":
    "Vos changements sont encore dans cette page : laissez-la ouverte, et relancez `kitrobot` sur le même dossier et le même port. Ou ouvrez l'adresse qu'il affiche.",
  "disk.changed": "{name} a changé sur le disque.",
  "disk.load": "Le charger",
  "disk.keep": "Garder celui-ci",
  "disk.difference": "Montrer la différence",
  "disk.removed": "{name} n'est plus sur le disque.",
  "disk.write": "L'écrire de nouveau",
  "disk.no-locks": "Ce dossier ne connaît pas de verrous, comme certains dossiers réseau.",
  "disk.no-locks-help":
    "Deux personnes qui enregistrent la même mission au même moment peuvent s'écraser l'une l'autre.",
  "disk.also-open": "ouvert aussi dans une autre fenêtre",
  "disk.also-open-help": "Chaque fenêtre garde ses changements. Qui enregistre en second doit choisir quoi faire.",
  "difference.title": "Le vôtre et celui du disque",
  "difference.none": "Ils sont pareils.",
  "difference.intro": "Ceci est différent dans le vôtre :",
} satisfies Table;
