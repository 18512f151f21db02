/** Urdu for the outline, the announcements and the help for a part. */
import type { Table } from "./words";

export const ACCESSIBILITY_UR = {
  "reach.undone": "واپس ہوا: {what}",
  "reach.redone": "دوبارہ ہوا: {what}",
  "reach.selected": "چنا گیا: {what}",

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

  "help.keys-save-as": "دوسرے نام سے محفوظ کریں",
  "help.keys-room": "صفحے کا اگلا حصہ، پچھلا حصہ",
  "help.keys-program": "اگلا پروگرام، پچھلا پروگرام",
  "help.keys-program-move": "پروگرام کا ٹیب ہٹائیں",
  "help.keys-rename": "پروگرام کا نام بدلیں",
  "help.keys-arc": "پرزے سے نکلتا تیر چنیں: پہلے اندر کے، پھر آگے کا",
  "help.keys-extend": "اگلا پرزہ بھی چنیں",
  "help.keys-note": "پرزے پر نوٹ لکھیں",
  "help.keys-move": "چنے ہوئے پرزے اوپر یا نیچے کریں",
  "help.keys-nothing": "کچھ نہ چنیں",
  "help.keys-pan": "منظر ہٹائیں",
  "help.keys-hand": "بورڈ کا بٹن دبائے رکھیں، یا اسے ہلائیں",
  "help.keys-robot": "اگلا روبوٹ، پچھلا روبوٹ",
  "help.keys-lists": "فہرستوں، ٹیبوں اور مینو میں",
  "help.keys-tabs": "ایک ٹیب سے دوسرے تک",
  "help.keys-tab-delete": "ٹیب کا پروگرام ہٹائیں",
  "help.keys-tree": "پرزوں کی فہرست میں چلیں، کھولیں اور بند کریں",
  "help.keys-tree-add": "پرزہ لگائیں، اندراج چنیں",
  "help.keys-lines": "دو خانوں کے بیچ کی لکیر یا سلائیڈر ہلائیں",
  "help.keys-paths": "مینو کے راستے",
  "help.keys-paths-how":
    "Alt مینو پر لے جاتا ہے؛ پہلا حرف یا تیر کوئی مینو کھولتے ہیں، حرف اور تیر اندراج تک لے جاتے ہیں، Enter اسے چنتا ہے۔",
  "program.next": "اگلا پروگرام",
  "program.previous": "پچھلا پروگرام",
  "program.later": "ٹیب آگے کریں",
  "program.earlier": "ٹیب پیچھے کریں",
} satisfies Table;
