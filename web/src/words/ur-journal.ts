/** Urdu for unsaved work that comes back, files that change on disk, and missions open twice. */
import type { Table } from "./words";

export const JOURNAL_UR = {
  "journal.back": "{name} پر آپ کا غیر محفوظ کام واپس آ گیا ہے۔",
  "journal.back-help": "«واپس کریں» پہلے کی طرح کام کرتا ہے۔",
  "journal.back-damaged": "روزنامچہ خراب تھا: شاید آخری قدم موجود نہ ہوں۔",
  "journal.back-steps": "آپ کا سارا کام موجود ہے، مگر روزنامچہ خراب تھا: پرانے قدم اب واپس نہیں لیے جا سکتے۔",
  "journal.failed-help": "اپنا کام ابھی محفوظ کریں: فائل میں وہ محفوظ رہے گا۔",
  "journal.discard": "اسے چھوڑ دیں",
  "journal.left": "{name} پر غیر محفوظ کام رکھا ہوا ہے۔",
  "journal.open": "اسے کھولیں",
  "journal.later": "بعد میں",
  "journal.failed": "اس وقت آپ کی تبدیلیاں محفوظ نہیں رکھی جا رہیں۔",
  "disk.changed": "{name} ڈسک پر بدل گیا ہے۔",
  "disk.load": "اسے لائیں",
  "disk.keep": "یہی رکھیں",
  "disk.difference": "فرق دکھائیں",
  "disk.removed": "{name} اب ڈسک پر نہیں ہے۔",
  "disk.write": "اسے پھر لکھیں",
  "disk.no-locks": "یہ فولڈر تالے نہیں جانتا، جیسے کچھ نیٹ ورک فولڈر نہیں جانتے۔",
  "disk.no-locks-help": "دو لوگ جو ایک ہی مشن ایک ہی لمحے محفوظ کریں، ایک دوسرے کا کام مٹا سکتے ہیں۔",
  "disk.also-open": "دوسری کھڑکی میں بھی کھلا ہے",
  "disk.also-open-help": "ہر کھڑکی اپنی تبدیلیاں رکھتی ہے۔ جو بعد میں محفوظ کرے اس سے پوچھا جاتا ہے کہ کیا کرنا ہے۔",
  "difference.title": "آپ کا اور ڈسک والا",
  "difference.none": "دونوں ایک جیسے ہیں۔",
  "difference.intro": "آپ والے میں یہ مختلف ہے:",
} satisfies Table;
