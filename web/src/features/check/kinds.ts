/** What a failure may be: the choices of a check, and what they are called. */
import type { VerifyStartRequest } from "../../api/generated";
import { t } from "../../i18n/words";

export type Kinds = NonNullable<VerifyStartRequest["kinds"]>;

/** How many failures there may be in one run, as values of a field. */
export const FAILURE_COUNTS = ["0", "1", "2", "3"];

export const USUAL: Kinds = ["fail", "stall"];

const CHOICES: readonly Kinds[] = [USUAL, ["fail"], ["stall"], ["mute"], ["fail", "stall", "mute"]];

/** Kinds as the value of a field. */
export function valueOf(kinds: Kinds): string {
  return kinds.join();
}

export function kindsOf(value: string): Kinds {
  return CHOICES.find((one) => valueOf(one) === value) ?? USUAL;
}

/** The choices of a field, with their words. */
export function kindChoices(): [string, string][] {
  return CHOICES.map((kinds) => [valueOf(kinds), kindWords(kinds)]);
}

/** "loses its radio" */
export function kindWords(kinds: Kinds): string {
  const [first = "fail", ...more] = kinds;
  if (more.length === 0) return t(`team.${first}`);
  return valueOf(kinds) === valueOf(USUAL) ? t("check.kinds-usual") : t("check.kinds-any");
}

/** The words for so many failures, and what these are where they are not the usual ones. */
export function withKinds(failures: string, kinds: Kinds): string {
  if (valueOf(kinds) === valueOf(USUAL)) return failures;
  return t("check.of-kinds", { failures, kinds: kindWords(kinds) });
}
