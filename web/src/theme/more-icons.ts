/** Icons that only some pages show: of micro:bits, of store managers, of programs of a team, of a class. */
import type { LucideIcon } from "lucide-react";

import ArrowRight from "lucide-react/icons/arrow-right";
import ArrowRightLeft from "lucide-react/icons/arrow-right-left";
import CircleDashed from "lucide-react/icons/circle-dashed";
import Clapperboard from "lucide-react/icons/clapperboard";
import ClipboardCheck from "lucide-react/icons/clipboard-check";
import ClipboardList from "lucide-react/icons/clipboard-list";
import FileCode from "lucide-react/icons/file-code";
import FolderDown from "lucide-react/icons/folder-down";
import Footprints from "lucide-react/icons/footprints";
import Grab from "lucide-react/icons/grab";
import Grid3x3 from "lucide-react/icons/grid-3x3";
import Hand from "lucide-react/icons/hand";
import HardDrive from "lucide-react/icons/hard-drive";
import ListOrdered from "lucide-react/icons/list-ordered";
import PackageMinus from "lucide-react/icons/package-minus";
import PackagePlus from "lucide-react/icons/package-plus";
import Rows3 from "lucide-react/icons/rows-3";
import ScanEye from "lucide-react/icons/scan-eye";
import Sun from "lucide-react/icons/sun";
import Thermometer from "lucide-react/icons/thermometer";
import Send from "lucide-react/icons/send";
import Snowflake from "lucide-react/icons/snowflake";
import UserCheck from "lucide-react/icons/user-check";
import UserPlus from "lucide-react/icons/user-plus";
import UserRound from "lucide-react/icons/user-round";
import Vibrate from "lucide-react/icons/vibrate";
import Volume2 from "lucide-react/icons/volume-2";
import Vote from "lucide-react/icons/vote";
import Warehouse from "lucide-react/icons/warehouse";
import Wrench from "lucide-react/icons/wrench";

export const MORE_ICONS: Readonly<Record<string, LucideIcon>> = {
  "arrow-right": ArrowRight,
  "arrow-right-left": ArrowRightLeft,
  "circle-dashed": CircleDashed,
  clapperboard: Clapperboard,
  "clipboard-check": ClipboardCheck,
  "clipboard-list": ClipboardList,
  "file-code": FileCode,
  "folder-down": FolderDown,
  footprints: Footprints,
  grab: Grab,
  "grid-3x3": Grid3x3,
  hand: Hand,
  "hard-drive": HardDrive,
  "list-ordered": ListOrdered,
  "package-minus": PackageMinus,
  "package-plus": PackagePlus,
  "rows-3": Rows3,
  "scan-eye": ScanEye,
  sun: Sun,
  thermometer: Thermometer,
  send: Send,
  snowflake: Snowflake,
  "user-check": UserCheck,
  "user-plus": UserPlus,
  "user-round": UserRound,
  vibrate: Vibrate,
  "volume-2": Volume2,
  vote: Vote,
  warehouse: Warehouse,
  wrench: Wrench,
};
