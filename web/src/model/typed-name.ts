/** A name as it is typed: without spaces around it, in the one form of Unicode in which equal names are equal (NFC). */
export function typedName(text: string): string {
  return text.normalize("NFC").trim();
}
