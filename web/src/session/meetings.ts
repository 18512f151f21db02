/** What is said of a meeting at which members of a team wait for others. */
import type { Meeting } from "../api/generated";
import { listed, t } from "../i18n/words";

/** More names than this are counted. */
const NAMED = 3;

/** How many of how many are there, and who is missing. */
export function meetingSaid({ here_count, count, missing }: Meeting): string {
  const names = missing.slice(0, NAMED);
  const others = count - here_count - names.length;
  return t("members.meeting", {
    here: here_count,
    wanted: count,
    names: listed(others > 0 ? [...names, t("members.others", { count: others })] : names),
    count: count - here_count,
  });
}
