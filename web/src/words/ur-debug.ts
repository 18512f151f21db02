/** Breakpoints and the watch, in Urdu. */
import type { Table } from "./words";

export const DEBUG_UR = {
  "debug.breakpoint": "یہاں رکیں",
  "debug.breakpoint-off": "یہاں رکیں، بند",
  "debug.toggle": "یہاں رکیں یا نہ رکیں",
  "debug.says-when": "جب {when}",
  "debug.says-hits": "{hits} ویں بار سے",
  "debug.when": "صرف جب",
  "debug.hits": "کس بار سے",
  "debug.who": "کن کے لیے",
  "debug.every": "صرف جب سب یہاں ہوں",
  "debug.paused-at": "رکا ہوا: {agent} یہاں {visit} ویں بار آیا",
  "debug.watch": "نگرانی",
  "debug.watch-close": "نگرانی بند کریں",
  "debug.watch-nothing": "چلائیں دبائیں: یہاں روبوٹ کے متغیرات اور سینسر دکھائی دیں گے، اور آپ انھیں بدل سکیں گے۔",
  "debug.agent": "روبوٹ",
  "debug.name": "نام",
  "debug.value": "قدر",
  "debug.plot": "وقت کے ساتھ",
  "debug.plot-of": "{name} وقت کے ساتھ",
  "debug.yes": "ہاں",
  "debug.no": "نہیں",
  "debug.release": "چھوڑ دیں",
  "debug.release-help": "آپ نے سینسر کی پیمائش کی جگہ یہ قدر رکھی ہے۔ چھوڑ دیں تو سینسر پھر سے ناپے گا۔",
} satisfies Table;
