/** Urdu for the outline, the announcements and the help for a part. */
import type { Table } from "./words";

export const REACH_UR = {
  "reach.undone": "واپس ہوا: {what}",
  "reach.redone": "دوبارہ ہوا: {what}",

  "outline.title": "فہرستِ پروگرام",
  "outline.of": "{name} کی فہرست",
  "outline.close": "فہرست بند کریں",

  "part-help.title": "پرزے کی مدد",
  "part-help.how": "خاکے میں یا پرزوں کی فہرست میں کوئی پرزہ چنیں، پھر F1 دبائیں۔",
  "part-help.range": "{min} سے {max} تک پورا عدد، شروع میں {first}",
  "part-help.switch": "درست یا غلط",
  "part-help.text": "متن",
  "part-help.condition": "یہاں شرط آتی ہے۔",
  "part-help.value": "یہاں قدر آتی ہے۔",
  "part-help.action": "یہاں روبوٹ کا عمل آتا ہے۔",
  "part-help.body": "اندر دوسرے پرزے آتے ہیں۔",

  "help.part": "چنے ہوئے پرزے کی مدد",
  "help.keys-part": "چنے ہوئے پرزے کی مدد",
  "help.keys-outline": "پروگرام لفظوں میں",
} satisfies Table;
