/** Why the server did not do some work: a sentence, a way out, and the mission's problems. */
import { ApiError } from "../api/client";
import type { WorkRefusedMessage } from "../api/generated";

export type WhyRefused = Pick<WorkRefusedMessage, "message" | "help" | "problems">;

/** What a request that failed says of itself. */
export function whyRefused(cause: unknown): WhyRefused {
  if (cause instanceof ApiError) return { message: cause.message, help: cause.help, problems: [...cause.problems] };
  return { message: String(cause), help: "", problems: [] };
}
