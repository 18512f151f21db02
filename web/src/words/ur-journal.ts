/** Urdu for unsaved work that comes back, files that change on disk, and missions open twice. */
import type { Table } from "./words";

export const JOURNAL_UR = {
  "journal.back": "{name} پر آپ کا غیر محفوظ کام واپس آ گیا ہے۔",
  "journal.back-help": "«واپس کریں» پہلے کی طرح کام کرتا ہے۔",
  "journal.back-damaged": "روزنامچہ خراب تھا: شاید آخری قدم موجود نہ ہوں۔",
  "journal.discard": "اسے چھوڑ دیں",
  "journal.left": "{name} پر غیر محفوظ کام رکھا ہوا ہے۔",
  "journal.open": "اسے کھولیں",
  "journal.later": "بعد میں",
  "journal.failed": "اس وقت آپ کی تبدیلیاں محفوظ نہیں رکھی جا رہیں۔",
  "journal.returned": "اسٹوڈیو دوبارہ شروع ہوا، اور یہ صفحہ اس کے ساتھ آگے چل رہا ہے۔",
  "journal.returned-help": "آپ کی تبدیلیاں محفوظ رکھی گئی ہیں۔",
  "journal.stranger": "اس صفحے کے اسٹوڈیو کی جگہ کوئی اور ہے۔",
  "journal.stranger-help":
    "آپ کی تبدیلیاں ابھی اس صفحے میں ہیں: اسے کھلا رہنے دیں، اور `kitrobot` کو اسی فولڈر اور اسی پورٹ پر دوبارہ چلائیں۔ یا وہ پتا کھولیں جو وہ دکھاتا ہے۔",
  "disk.changed": "{name} ڈسک پر بدل گیا ہے۔",
  "disk.load": "اسے لائیں",
  "disk.keep": "یہی رکھیں",
  "disk.difference": "فرق دکھائیں",
  "disk.removed": "{name} اب ڈسک پر نہیں ہے۔",
  "disk.write": "اسے پھر لکھیں",
  "disk.also-open": "دوسری کھڑکی میں بھی کھلا ہے",
  "disk.also-open-help": "ہر کھڑکی اپنی تبدیلیاں رکھتی ہے۔ جو بعد میں محفوظ کرے اس سے پوچھا جاتا ہے کہ کیا کرنا ہے۔",
  "difference.title": "آپ کا اور ڈسک والا",
  "difference.none": "دونوں ایک جیسے ہیں۔",
  "difference.intro": "آپ والے میں یہ مختلف ہے:",
} satisfies Table;
