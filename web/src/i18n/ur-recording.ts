/** Recordings, in Urdu. */
import type { Table } from "./words";

export const RECORDING_UR = {
  "recording.playing": "آپ ایک ریکارڈنگ دیکھ رہے ہیں: {name}، بیج {seed}۔",
  "recording.real": "آپ ایک اصلی روبوٹ کی ریکارڈنگ دیکھ رہے ہیں: {name}۔",
  "recording.live": "اب ریکارڈنگ {name} کا مشن نئے سرے سے چل رہا ہے، بیج {seed} کے ساتھ۔",
  "recording.nothing": "اس میں جیسے چاہیں آگے پیچھے جائیں؛ اس میں کچھ بدلا نہیں جا سکتا۔",
  "recording.breakpoints":
    "یہ «یہاں رکیں» والے حصے پر وہاں رکتی ہے جہاں اس میں نظر آئے کہ روبوٹ وہاں تھا: وہ وہاں ٹھہرا ہو، یا ایسا حکم دیا ہو جو کوئی اور حصہ نہیں دے سکتا۔",
  "recording.cut": "اس کی فائل کٹ گئی تھی: یہ چلن کے ختم ہونے سے پہلے رک جاتی ہے۔",
  "recording.run": "یہ مشن چلائیں",
  "recording.again": "دوبارہ دیکھیں",
  "recording.play": "ریکارڈنگ پر واپس",
  "recording.save": "یہ چلن محفوظ کریں…",
  "recording.title": "ریکارڈنگ سے",
  "recording.list": "{folder} میں ریکارڈنگز",
  "status.end": "ریکارڈنگ یہاں ختم ہوتی ہے",
  "strip.outside": "ہاتھ سے",
} satisfies Table;
