/** Runs that another window steers, in Urdu. */
import type { Table } from "./words";

export const WATCHING_UR = {
  "watching.offer": "یہ مشن ایک اور کھڑکی میں چل رہا ہے۔",
  "watching.watch": "دیکھیں",
  "watching.on": "آپ وہ چلن دیکھ رہے ہیں جسے ایک اور کھڑکی چلا رہی ہے؛ یہاں رکو دبانے سے صرف دیکھنا بند ہوتا ہے۔",
  "watching.another": "وہاں جو چل رہا ہے وہ یہاں کھلا ہوا نہیں: ہو سکتا ہے کچھ حصے نہ جلیں۔",
  "watching.leave": "دیکھنا بند کریں",
} satisfies Table;
