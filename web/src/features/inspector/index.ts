/** What can be set on the selected part. */
import type { Feature } from "../../session/features";
import { Inspector } from "./Inspector";

export const inspector: Feature = { name: "inspector", panels: { inspector: Inspector } };
