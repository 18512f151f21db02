/** What axe finds in what is mounted: names, roles and order; jsdom has no colours and no layout, which browsers look at. */
import axe from "axe-core";

/** "RULE: TARGET" of each thing that is wrong. */
export async function barriersIn(place: Element): Promise<string[]> {
  const rules = { "color-contrast": { enabled: false }, region: { enabled: false } };
  const { violations } = await axe.run(place, { resultTypes: ["violations"], rules });
  return violations.flatMap(({ id, nodes }) => nodes.map(({ target }) => `${id}: ${target.join(" ")}`));
}
