/** French for what leaves the studio: files to keep and the printed sheet. */
import type { Table } from "./words";

export const EXPORT_FR = {
  "out.download-kri": "Télécharger l’image de {name} (.kri)",
  "out.download-kra": "Télécharger le code à trois adresses de {name} (.kra)",
  "out.no-image": "« {name} » a des erreurs : il n’y en a pas encore d’image.",
  "out.no-image-help": "Corrigez ce que montre la liste des problèmes ; F8 va au suivant.",
  "out.show-problem": "Montrer l’erreur",
  "out.export-pdf": "Exporter le graphe en PDF",
  "out.export-pdf-all": "Exporter tous les graphes en PDF",
  "out.print": "Imprimer…",
  "out.print-failed": "La feuille n’a pas pu être faite : rechargez la page.",

  "sheet.team": "L’équipe",
  "sheet.agent": "Agent",
  "sheet.program": "Programme",
  "sheet.robot": "Robot",
  "sheet.start": "Départ",
  "sheet.world": "Monde : {name}",
  "sheet.part": "{name} · graphe, partie {number} sur {total}",
  "sheet.graph": "Graphe de {name}",
  "sheet.no-code": "Ce programme n’a pas encore de texte : il faut d’abord corriger ses erreurs.",
} as const satisfies Table;
