/** Recordings, in French. */
import type { Table } from "./words";

export const RECORDING_FR = {
  "recording.playing": "Vous regardez un enregistrement : {name}, graine {seed}.",
  "recording.real": "Vous regardez l'enregistrement d'un vrai robot : {name}.",
  "recording.live": "La mission de l'enregistrement {name} tourne maintenant à nouveau, avec la graine {seed}.",
  "recording.nothing": "Avancez et reculez comme vous voulez ; on ne peut rien y changer.",
  "recording.breakpoints":
    "Il s'arrête à une pièce marquée « Pause ici » quand il montre qu'un robot y était : s'il s'y tenait, ou donnait un ordre qu'aucune autre pièce ne peut donner.",
  "recording.cut": "Son fichier a été coupé : il finit avant la fin de l'exécution.",
  "recording.run": "Lancer cette mission",
  "recording.again": "Rejouer",
  "recording.play": "Revenir à l'enregistrement",
  "recording.save": "Enregistrer cette exécution…",
  "recording.title": "issu d'un enregistrement",
  "recording.list": "Enregistrements dans {folder}",
  "status.end": "L'enregistrement s'arrête ici",
  "strip.outside": "à la main",
} satisfies Table;
