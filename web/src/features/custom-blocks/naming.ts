/** Names of parts: which are free, and what is wrong with one. */
import { t } from "../../i18n/words";
import { firstFree } from "../../model/free-name";
import { ownConstructors } from "../../model/own-parts";
import { typedName } from "../../model/typed-name";
import type { Catalogue, Constructor, Mission } from "../../model/types";

function takenIn(catalogue: Catalogue): Set<string> {
  return new Set(catalogue.groups.flatMap((group) => group.constructors.map((one) => one.name)));
}

/** What is wrong with a name, or "". `own` is the name that the part has already. */
export function wrongWith(name: string, catalogue: Catalogue, own = ""): string {
  const whole = plainName(name);
  if (whole === "") return t("own.name-empty");
  if (whole.includes(".") || whole === "Start" || whole === "Stop") return t("own.name-wrong");
  return whole !== own && takenIn(catalogue).has(whole) ? t("own.name-taken", { name: whole }) : "";
}

export function plainName(name: string): string {
  return typedName(name).replace(/\s+/g, " ");
}

/** "My part", "My part 2", …: the first that is free. */
export function freePartName(catalogue: Catalogue): string {
  const taken = takenIn(catalogue);
  const stem = t("own.default");
  return firstFree(
    (number) => (number === 1 ? stem : `${stem} ${String(number)}`),
    (name) => taken.has(name),
  );
}

export function ownPart(mission: Mission, name: string): Constructor | undefined {
  return ownConstructors(mission).find((one) => one.name === name);
}
