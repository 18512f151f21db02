/** Why something could not be done, in words. */
import { ApiError } from "./client";
import type { WorkRefusedMessage } from "./generated";

/** A sentence, and a way out. */
export type Failure = Pick<WorkRefusedMessage, "message" | "help">;

/** Why the server did not do some work: a sentence, a way out, and the mission's problems. */
export type WhyRefused = Pick<WorkRefusedMessage, "message" | "help" | "problems">;

/** What a request that failed says of itself. */
export function whyRefused(cause: unknown): WhyRefused {
  if (cause instanceof ApiError) return { message: cause.message, help: cause.help, problems: [...cause.problems] };
  return { message: cause instanceof Error ? cause.message : String(cause), help: "", problems: [] };
}

/** The same in one line. */
export function failureWords(cause: unknown): string {
  const { message, help } = whyRefused(cause);
  return `${message} ${help}`.trim();
}
