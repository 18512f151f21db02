/** The place where the robots are. */
import type { Feature } from "../../session/features";
import { Arena } from "./Arena";

export const arena: Feature = { name: "arena", panels: { arena: Arena } };
