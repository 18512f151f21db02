/** The properties that a mission asks for itself. */
import { t } from "../../i18n/words";
import { becomes, type Command } from "../command";
import type { AskedProperty, Mission } from "../types";

/** Other properties; null when they are the same. */
export function setProperties(mission: Mission, properties: readonly AskedProperty[]): Command | null {
  const { properties: before = [], ...rest } = mission;
  if (JSON.stringify(before) === JSON.stringify(properties)) return null;
  const after = properties.length === 0 ? rest : { ...rest, properties: [...properties] };
  return becomes(t("command.properties"), after);
}

/** A name that no property has yet. */
export function freePropertyName(properties: readonly AskedProperty[]): string {
  const taken = new Set(properties.map(({ name }) => name));
  let number = 1;
  while (taken.has(`property-${String(number)}`)) number += 1;
  return `property-${String(number)}`;
}
