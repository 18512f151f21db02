/** The whole of lucide, in a chunk that is fetched only when some XML names an icon outside the bounded set. */
import { icons } from "lucide-react";

export const ALL_ICONS = icons;
