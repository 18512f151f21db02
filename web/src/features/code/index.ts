/** The program in view as text. */
import type { Feature } from "../../session/features";
import { Code } from "./Code";

export const code: Feature = { name: "code", panels: { code: Code } };
