/** Urdu for what leaves the studio: files to keep and the printed sheet. */
import type { Table } from "./words";

export const EXPORT_UR = {
  "out.download-kri": "{name} کا امیج اتاریں (.kri)",
  "out.download-kra": "{name} کا سہ پتہ کوڈ اتاریں (.kra)",
  "out.no-image": "«{name}» میں غلطیاں ہیں، اس لیے ابھی اس کا امیج نہیں بن سکتا۔",
  "out.no-image-help": "مسائل کی فہرست میں جو غلطیاں ہیں انھیں درست کریں؛ F8 اگلی غلطی پر لے جاتا ہے۔",
  "out.show-problem": "غلطی دکھائیں",
  "out.export-pdf": "گراف PDF میں محفوظ کریں",
  "out.export-pdf-all": "تمام گراف PDF میں محفوظ کریں",
  "out.print": "چھاپیں…",
  "out.print-failed": "صفحہ نہیں بن سکا: صفحہ دوبارہ کھولیں۔",

  "sheet.team": "ٹیم",
  "sheet.agent": "ایجنٹ",
  "sheet.program": "پروگرام",
  "sheet.robot": "روبوٹ",
  "sheet.start": "آغاز کی جگہ",
  "sheet.world": "دنیا: {name}",
  "sheet.part": "{name} · گراف، حصہ {number} از {total}",
  "sheet.graph": "{name} کا گراف",
  "sheet.no-code": "اس پروگرام کا متن ابھی نہیں ہے: پہلے اس کی غلطیاں درست کریں۔",
} as const satisfies Table;
