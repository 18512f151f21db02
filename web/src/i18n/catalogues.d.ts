/** A catalogue as `build/catalogues.ts` gives it: each sentence, or its form for each plural rule, by key. */
declare module "*.po" {
  const table: Readonly<Record<string, string | ({ other: string } & Partial<Record<Intl.LDMLPluralRule, string>>)>>;
  export default table;
}

/** The sentences of what is fetched later. */
declare module "*.po?later" {
  const table: Readonly<Record<string, string | ({ other: string } & Partial<Record<Intl.LDMLPluralRule, string>>)>>;
  export default table;
}
