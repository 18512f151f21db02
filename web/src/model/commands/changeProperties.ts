/** The properties that a mission asks for itself. */
import { t } from "../../i18n/words";
import { type Command, commandTo, withOptional } from "../command";
import { freeName } from "../free-name";
import type { AskedProperty, Mission } from "../types";

/** Other properties; null when they are the same. */
export function setProperties(mission: Mission, properties: readonly AskedProperty[]): Command | null {
  if (JSON.stringify(mission.properties ?? []) === JSON.stringify(properties)) return null;
  return commandTo(t("command.properties"), withOptional(mission, { properties: [...properties] }));
}

/** A name that no property has yet. */
export function freePropertyName(properties: readonly AskedProperty[]): string {
  return freeName(
    "property",
    properties.map(({ name }) => name),
  );
}
