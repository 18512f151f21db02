/**
 * The icons that travel with the page: the lucide names that most pages show at once, no more; every load pays for them.
 *
 * What only some pages show is in `more-icons.ts`. A robot's or constructor's XML may name any lucide icon: `Icon.tsx` fetches
 * the whole set for a name that is in neither.
 */
import type { LucideIcon } from "lucide-react";

import Ampersand from "lucide-react/icons/ampersand";
import ArrowDown from "lucide-react/icons/arrow-down";
import ArrowUp from "lucide-react/icons/arrow-up";
import Ban from "lucide-react/icons/ban";
import Bell from "lucide-react/icons/bell";
import Blend from "lucide-react/icons/blend";
import Bot from "lucide-react/icons/bot";
import Box from "lucide-react/icons/box";
import Boxes from "lucide-react/icons/boxes";
import BrickWall from "lucide-react/icons/brick-wall";
import Check from "lucide-react/icons/check";
import ChevronDown from "lucide-react/icons/chevron-down";
import ChevronLeft from "lucide-react/icons/chevron-left";
import ChevronRight from "lucide-react/icons/chevron-right";
import ChevronUp from "lucide-react/icons/chevron-up";
import Circle from "lucide-react/icons/circle";
import CircleCheck from "lucide-react/icons/circle-check";
import CircleDot from "lucide-react/icons/circle-dot";
import CircleHelp from "lucide-react/icons/circle-help";
import CircleSlash2 from "lucide-react/icons/circle-slash-2";
import CircleX from "lucide-react/icons/circle-x";
import Columns2 from "lucide-react/icons/columns-2";
import Compass from "lucide-react/icons/compass";
import Copy from "lucide-react/icons/copy";
import Crosshair from "lucide-react/icons/crosshair";
import Disc3 from "lucide-react/icons/disc-3";
import DoorClosed from "lucide-react/icons/door-closed";
import DoorOpen from "lucide-react/icons/door-open";
import Ellipsis from "lucide-react/icons/ellipsis";
import Equal from "lucide-react/icons/equal";
import Dices from "lucide-react/icons/dices";
import Eye from "lucide-react/icons/eye";
import File from "lucide-react/icons/file";
import Flag from "lucide-react/icons/flag";
import Gauge from "lucide-react/icons/gauge";
import GitFork from "lucide-react/icons/git-fork";
import GraduationCap from "lucide-react/icons/graduation-cap";
import Hash from "lucide-react/icons/hash";
import Hourglass from "lucide-react/icons/hourglass";
import ImageIcon from "lucide-react/icons/image";
import InfinityIcon from "lucide-react/icons/infinity";
import Info from "lucide-react/icons/info";
import Lightbulb from "lucide-react/icons/lightbulb";
import LightbulbOff from "lucide-react/icons/lightbulb-off";
import ListPlus from "lucide-react/icons/list-plus";
import LogOut from "lucide-react/icons/log-out";
import Map from "lucide-react/icons/map";
import MapPin from "lucide-react/icons/map-pin";
import Maximize from "lucide-react/icons/maximize";
import Maximize2 from "lucide-react/icons/maximize-2";
import MessageCircle from "lucide-react/icons/message-circle";
import Minus from "lucide-react/icons/minus";
import MoveDown from "lucide-react/icons/move-down";
import MoveUp from "lucide-react/icons/move-up";
import MousePointer2 from "lucide-react/icons/mouse-pointer-2";
import OctagonX from "lucide-react/icons/octagon-x";
import Package from "lucide-react/icons/package";
import PackageOpen from "lucide-react/icons/package-open";
import Palette from "lucide-react/icons/palette";
import Pause from "lucide-react/icons/pause";
import PencilOff from "lucide-react/icons/pencil-off";
import Ruler from "lucide-react/icons/ruler";
import Eraser from "lucide-react/icons/eraser";
import ToggleLeft from "lucide-react/icons/toggle-left";
import Music from "lucide-react/icons/music";
import Pencil from "lucide-react/icons/pencil";
import Play from "lucide-react/icons/play";
import Plus from "lucide-react/icons/plus";
import Power from "lucide-react/icons/power";
import PowerOff from "lucide-react/icons/power-off";
import Radar from "lucide-react/icons/radar";
import Radio from "lucide-react/icons/radio";
import Redo2 from "lucide-react/icons/redo-2";
import RedoDot from "lucide-react/icons/redo-dot";
import RefreshCw from "lucide-react/icons/refresh-cw";
import Repeat from "lucide-react/icons/repeat";
import RotateCw from "lucide-react/icons/rotate-cw";
import Search from "lucide-react/icons/search";
import Settings from "lucide-react/icons/settings";
import Signpost from "lucide-react/icons/signpost";
import SlidersHorizontal from "lucide-react/icons/sliders-horizontal";
import Split from "lucide-react/icons/split";
import Square from "lucide-react/icons/square";
import SquareDashed from "lucide-react/icons/square-dashed";
import StepBack from "lucide-react/icons/step-back";
import StepForward from "lucide-react/icons/step-forward";
import Timer from "lucide-react/icons/timer";
import ToggleRight from "lucide-react/icons/toggle-right";
import Trash2 from "lucide-react/icons/trash-2";
import TriangleAlert from "lucide-react/icons/triangle-alert";
import Undo2 from "lucide-react/icons/undo-2";
import Upload from "lucide-react/icons/upload";
import Users from "lucide-react/icons/users";
import Variable from "lucide-react/icons/variable";
import X from "lucide-react/icons/x";
import Zap from "lucide-react/icons/zap";
import ZoomIn from "lucide-react/icons/zoom-in";
import ZoomOut from "lucide-react/icons/zoom-out";

export const ICONS: Readonly<Record<string, LucideIcon>> = {
  ampersand: Ampersand,
  "arrow-down": ArrowDown,
  "arrow-up": ArrowUp,
  ban: Ban,
  bell: Bell,
  blend: Blend,
  bot: Bot,
  box: Box,
  boxes: Boxes,
  "brick-wall": BrickWall,
  check: Check,
  "chevron-down": ChevronDown,
  "chevron-left": ChevronLeft,
  "chevron-right": ChevronRight,
  "chevron-up": ChevronUp,
  circle: Circle,
  "circle-check": CircleCheck,
  "circle-dot": CircleDot,
  "circle-help": CircleHelp,
  "circle-slash-2": CircleSlash2,
  "circle-x": CircleX,
  "columns-2": Columns2,
  compass: Compass,
  copy: Copy,
  crosshair: Crosshair,
  "disc-3": Disc3,
  "door-closed": DoorClosed,
  "door-open": DoorOpen,
  ellipsis: Ellipsis,
  equal: Equal,
  dices: Dices,
  eye: Eye,
  file: File,
  flag: Flag,
  gauge: Gauge,
  "git-fork": GitFork,
  "graduation-cap": GraduationCap,
  hash: Hash,
  hourglass: Hourglass,
  image: ImageIcon,
  infinity: InfinityIcon,
  info: Info,
  lightbulb: Lightbulb,
  "lightbulb-off": LightbulbOff,
  "list-plus": ListPlus,
  "log-out": LogOut,
  map: Map,
  "map-pin": MapPin,
  maximize: Maximize,
  "maximize-2": Maximize2,
  "message-circle": MessageCircle,
  minus: Minus,
  "mouse-pointer-2": MousePointer2,
  "move-down": MoveDown,
  "move-up": MoveUp,
  "octagon-x": OctagonX,
  package: Package,
  "package-open": PackageOpen,
  palette: Palette,
  pause: Pause,
  "pencil-off": PencilOff,
  ruler: Ruler,
  eraser: Eraser,
  "toggle-left": ToggleLeft,
  music: Music,
  pencil: Pencil,
  play: Play,
  plus: Plus,
  power: Power,
  "power-off": PowerOff,
  radar: Radar,
  radio: Radio,
  "redo-2": Redo2,
  "redo-dot": RedoDot,
  "refresh-cw": RefreshCw,
  repeat: Repeat,
  "rotate-cw": RotateCw,
  search: Search,
  settings: Settings,
  signpost: Signpost,
  "sliders-horizontal": SlidersHorizontal,
  split: Split,
  square: Square,
  "square-dashed": SquareDashed,
  "step-back": StepBack,
  "step-forward": StepForward,
  timer: Timer,
  "toggle-right": ToggleRight,
  "trash-2": Trash2,
  "triangle-alert": TriangleAlert,
  "undo-2": Undo2,
  upload: Upload,
  users: Users,
  variable: Variable,
  x: X,
  zap: Zap,
  "zoom-in": ZoomIn,
  "zoom-out": ZoomOut,
};
