/** What a person types into a field that looks for something: any case, any accents, words in any order. */

/** Without accents and capitals: who types “carre” means “carré”. */
export function plain(text: string): string {
  return text.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();
}

/** Whether a text holds each word of what is looked for; without words every text does. */
export function holding(query: string): (text: string) => boolean {
  const words = plain(query).split(/\s+/).filter(Boolean);
  return (text) => {
    if (words.length === 0) return true;
    const told = plain(text);
    return words.every((word) => told.includes(word));
  };
}
