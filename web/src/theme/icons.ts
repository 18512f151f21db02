/**
 * The icons that travel with the page: lucide names, a bounded set.
 *
 * A robot's or constructor's XML may name any lucide icon; `Icon.tsx` fetches the whole set for a name that is not here.
 */
import type { LucideIcon } from "lucide-react";

import Activity from "lucide-react/icons/activity";
import AlarmClock from "lucide-react/icons/alarm-clock";
import Ampersand from "lucide-react/icons/ampersand";
import Ampersands from "lucide-react/icons/ampersands";
import Anchor from "lucide-react/icons/anchor";
import Antenna from "lucide-react/icons/antenna";
import AppWindow from "lucide-react/icons/app-window";
import Archive from "lucide-react/icons/archive";
import ArrowBigUp from "lucide-react/icons/arrow-big-up";
import ArrowDown from "lucide-react/icons/arrow-down";
import ArrowDownLeft from "lucide-react/icons/arrow-down-left";
import ArrowDownRight from "lucide-react/icons/arrow-down-right";
import ArrowDownToLine from "lucide-react/icons/arrow-down-to-line";
import ArrowLeft from "lucide-react/icons/arrow-left";
import ArrowLeftRight from "lucide-react/icons/arrow-left-right";
import ArrowRight from "lucide-react/icons/arrow-right";
import ArrowRightLeft from "lucide-react/icons/arrow-right-left";
import ArrowUp from "lucide-react/icons/arrow-up";
import ArrowUp01 from "lucide-react/icons/arrow-up-0-1";
import ArrowUpDown from "lucide-react/icons/arrow-up-down";
import ArrowUpLeft from "lucide-react/icons/arrow-up-left";
import ArrowUpRight from "lucide-react/icons/arrow-up-right";
import ArrowUpToLine from "lucide-react/icons/arrow-up-to-line";
import AudioLines from "lucide-react/icons/audio-lines";
import BadgeAlert from "lucide-react/icons/badge-alert";
import BadgeCheck from "lucide-react/icons/badge-check";
import Ban from "lucide-react/icons/ban";
import Battery from "lucide-react/icons/battery";
import Bell from "lucide-react/icons/bell";
import BellDot from "lucide-react/icons/bell-dot";
import BellRing from "lucide-react/icons/bell-ring";
import BetweenHorizontalStart from "lucide-react/icons/between-horizontal-start";
import Bike from "lucide-react/icons/bike";
import Binary from "lucide-react/icons/binary";
import Binoculars from "lucide-react/icons/binoculars";
import Blocks from "lucide-react/icons/blocks";
import Bluetooth from "lucide-react/icons/bluetooth";
import Bookmark from "lucide-react/icons/bookmark";
import Bot from "lucide-react/icons/bot";
import Box from "lucide-react/icons/box";
import Boxes from "lucide-react/icons/boxes";
import Braces from "lucide-react/icons/braces";
import Brackets from "lucide-react/icons/brackets";
import Brain from "lucide-react/icons/brain";
import Brush from "lucide-react/icons/brush";
import Bug from "lucide-react/icons/bug";
import Calculator from "lucide-react/icons/calculator";
import Camera from "lucide-react/icons/camera";
import Car from "lucide-react/icons/car";
import Check from "lucide-react/icons/check";
import ChevronDown from "lucide-react/icons/chevron-down";
import ChevronLeft from "lucide-react/icons/chevron-left";
import ChevronRight from "lucide-react/icons/chevron-right";
import ChevronUp from "lucide-react/icons/chevron-up";
import ChevronsDown from "lucide-react/icons/chevrons-down";
import ChevronsLeft from "lucide-react/icons/chevrons-left";
import ChevronsRight from "lucide-react/icons/chevrons-right";
import ChevronsUp from "lucide-react/icons/chevrons-up";
import Circle from "lucide-react/icons/circle";
import CircleAlert from "lucide-react/icons/circle-alert";
import CircleArrowDown from "lucide-react/icons/circle-arrow-down";
import CircleArrowLeft from "lucide-react/icons/circle-arrow-left";
import CircleArrowRight from "lucide-react/icons/circle-arrow-right";
import CircleArrowUp from "lucide-react/icons/circle-arrow-up";
import CircleCheck from "lucide-react/icons/circle-check";
import CircleDashed from "lucide-react/icons/circle-dashed";
import CircleDot from "lucide-react/icons/circle-dot";
import CircleGauge from "lucide-react/icons/circle-gauge";
import CircleHelp from "lucide-react/icons/circle-help";
import CircleParking from "lucide-react/icons/circle-parking";
import CircleParkingOff from "lucide-react/icons/circle-parking-off";
import CirclePause from "lucide-react/icons/circle-pause";
import CirclePlay from "lucide-react/icons/circle-play";
import CirclePlus from "lucide-react/icons/circle-plus";
import CircleSlash from "lucide-react/icons/circle-slash";
import CircleSlash2 from "lucide-react/icons/circle-slash-2";
import CircleStop from "lucide-react/icons/circle-stop";
import CircleX from "lucide-react/icons/circle-x";
import Clock from "lucide-react/icons/clock";
import Cloud from "lucide-react/icons/cloud";
import Code from "lucide-react/icons/code";
import Cog from "lucide-react/icons/cog";
import Columns2 from "lucide-react/icons/columns-2";
import Columns3 from "lucide-react/icons/columns-3";
import Compass from "lucide-react/icons/compass";
import Construction from "lucide-react/icons/construction";
import Container from "lucide-react/icons/container";
import Copy from "lucide-react/icons/copy";
import CornerDownLeft from "lucide-react/icons/corner-down-left";
import CornerDownRight from "lucide-react/icons/corner-down-right";
import CornerUpLeft from "lucide-react/icons/corner-up-left";
import CornerUpRight from "lucide-react/icons/corner-up-right";
import Cpu from "lucide-react/icons/cpu";
import Crosshair from "lucide-react/icons/crosshair";
import Diamond from "lucide-react/icons/diamond";
import Dices from "lucide-react/icons/dices";
import Diff from "lucide-react/icons/diff";
import Disc from "lucide-react/icons/disc";
import Disc3 from "lucide-react/icons/disc-3";
import DoorClosed from "lucide-react/icons/door-closed";
import DoorOpen from "lucide-react/icons/door-open";
import Download from "lucide-react/icons/download";
import Droplet from "lucide-react/icons/droplet";
import Ellipsis from "lucide-react/icons/ellipsis";
import Equal from "lucide-react/icons/equal";
import EqualNot from "lucide-react/icons/equal-not";
import Eye from "lucide-react/icons/eye";
import EyeOff from "lucide-react/icons/eye-off";
import Factory from "lucide-react/icons/factory";
import Fan from "lucide-react/icons/fan";
import File from "lucide-react/icons/file";
import FileCode from "lucide-react/icons/file-code";
import FilePlus from "lucide-react/icons/file-plus";
import FileText from "lucide-react/icons/file-text";
import Flag from "lucide-react/icons/flag";
import Flame from "lucide-react/icons/flame";
import Flashlight from "lucide-react/icons/flashlight";
import Folder from "lucide-react/icons/folder";
import FolderOpen from "lucide-react/icons/folder-open";
import Footprints from "lucide-react/icons/footprints";
import Forklift from "lucide-react/icons/forklift";
import Gamepad2 from "lucide-react/icons/gamepad-2";
import Gauge from "lucide-react/icons/gauge";
import GitBranch from "lucide-react/icons/git-branch";
import GitFork from "lucide-react/icons/git-fork";
import GitMerge from "lucide-react/icons/git-merge";
import Globe from "lucide-react/icons/globe";
import Grab from "lucide-react/icons/grab";
import Grid3x3 from "lucide-react/icons/grid-3x3";
import GripVertical from "lucide-react/icons/grip-vertical";
import Hand from "lucide-react/icons/hand";
import Hash from "lucide-react/icons/hash";
import Heart from "lucide-react/icons/heart";
import Hexagon from "lucide-react/icons/hexagon";
import Hourglass from "lucide-react/icons/hourglass";
import House from "lucide-react/icons/house";
import Image from "lucide-react/icons/image";
import Inbox from "lucide-react/icons/inbox";
import InfinityIcon from "lucide-react/icons/infinity";
import Info from "lucide-react/icons/info";
import IterationCcw from "lucide-react/icons/iteration-ccw";
import IterationCw from "lucide-react/icons/iteration-cw";
import Joystick from "lucide-react/icons/joystick";
import Key from "lucide-react/icons/key";
import Keyboard from "lucide-react/icons/keyboard";
import Lamp from "lucide-react/icons/lamp";
import LampCeiling from "lucide-react/icons/lamp-ceiling";
import LampDesk from "lucide-react/icons/lamp-desk";
import LandPlot from "lucide-react/icons/land-plot";
import Languages from "lucide-react/icons/languages";
import Layers from "lucide-react/icons/layers";
import LifeBuoy from "lucide-react/icons/life-buoy";
import Lightbulb from "lucide-react/icons/lightbulb";
import LightbulbOff from "lucide-react/icons/lightbulb-off";
import List from "lucide-react/icons/list";
import ListChecks from "lucide-react/icons/list-checks";
import Loader from "lucide-react/icons/loader";
import Locate from "lucide-react/icons/locate";
import Lock from "lucide-react/icons/lock";
import LockOpen from "lucide-react/icons/lock-open";
import LogIn from "lucide-react/icons/log-in";
import LogOut from "lucide-react/icons/log-out";
import Magnet from "lucide-react/icons/magnet";
import Mail from "lucide-react/icons/mail";
import Map from "lucide-react/icons/map";
import MapPin from "lucide-react/icons/map-pin";
import Maximize from "lucide-react/icons/maximize";
import Megaphone from "lucide-react/icons/megaphone";
import Menu from "lucide-react/icons/menu";
import MessageCircle from "lucide-react/icons/message-circle";
import Mic from "lucide-react/icons/mic";
import Milestone from "lucide-react/icons/milestone";
import Minus from "lucide-react/icons/minus";
import Monitor from "lucide-react/icons/monitor";
import Moon from "lucide-react/icons/moon";
import MousePointer2 from "lucide-react/icons/mouse-pointer-2";
import Move from "lucide-react/icons/move";
import Move3d from "lucide-react/icons/move-3d";
import MoveDown from "lucide-react/icons/move-down";
import MoveLeft from "lucide-react/icons/move-left";
import MoveRight from "lucide-react/icons/move-right";
import MoveUp from "lucide-react/icons/move-up";
import Music from "lucide-react/icons/music";
import Navigation from "lucide-react/icons/navigation";
import Navigation2 from "lucide-react/icons/navigation-2";
import Nfc from "lucide-react/icons/nfc";
import OctagonX from "lucide-react/icons/octagon-x";
import Package from "lucide-react/icons/package";
import PackageCheck from "lucide-react/icons/package-check";
import PackageMinus from "lucide-react/icons/package-minus";
import PackageOpen from "lucide-react/icons/package-open";
import PackagePlus from "lucide-react/icons/package-plus";
import Palette from "lucide-react/icons/palette";
import PanelsTopLeft from "lucide-react/icons/panels-top-left";
import Parentheses from "lucide-react/icons/parentheses";
import ParkingCircle from "lucide-react/icons/parking-circle";
import Pause from "lucide-react/icons/pause";
import Pen from "lucide-react/icons/pen";
import Pencil from "lucide-react/icons/pencil";
import Percent from "lucide-react/icons/percent";
import Pilcrow from "lucide-react/icons/pilcrow";
import Pin from "lucide-react/icons/pin";
import Plane from "lucide-react/icons/plane";
import Play from "lucide-react/icons/play";
import Plug from "lucide-react/icons/plug";
import Plus from "lucide-react/icons/plus";
import Power from "lucide-react/icons/power";
import Puzzle from "lucide-react/icons/puzzle";
import Rabbit from "lucide-react/icons/rabbit";
import Radar from "lucide-react/icons/radar";
import Radio from "lucide-react/icons/radio";
import RadioTower from "lucide-react/icons/radio-tower";
import Redo from "lucide-react/icons/redo";
import Redo2 from "lucide-react/icons/redo-2";
import RefreshCcw from "lucide-react/icons/refresh-ccw";
import RefreshCw from "lucide-react/icons/refresh-cw";
import Repeat from "lucide-react/icons/repeat";
import Repeat1 from "lucide-react/icons/repeat-1";
import Rocket from "lucide-react/icons/rocket";
import Rotate3d from "lucide-react/icons/rotate-3d";
import RotateCcw from "lucide-react/icons/rotate-ccw";
import RotateCw from "lucide-react/icons/rotate-cw";
import Route from "lucide-react/icons/route";
import RouteOff from "lucide-react/icons/route-off";
import Rows2 from "lucide-react/icons/rows-2";
import Rows3 from "lucide-react/icons/rows-3";
import Ruler from "lucide-react/icons/ruler";
import Save from "lucide-react/icons/save";
import Scale from "lucide-react/icons/scale";
import Scan from "lucide-react/icons/scan";
import ScanEye from "lucide-react/icons/scan-eye";
import ScanLine from "lucide-react/icons/scan-line";
import Search from "lucide-react/icons/search";
import Send from "lucide-react/icons/send";
import Settings from "lucide-react/icons/settings";
import Settings2 from "lucide-react/icons/settings-2";
import Shield from "lucide-react/icons/shield";
import Ship from "lucide-react/icons/ship";
import Shuffle from "lucide-react/icons/shuffle";
import Sigma from "lucide-react/icons/sigma";
import Signpost from "lucide-react/icons/signpost";
import SignpostBig from "lucide-react/icons/signpost-big";
import Siren from "lucide-react/icons/siren";
import SkipBack from "lucide-react/icons/skip-back";
import SkipForward from "lucide-react/icons/skip-forward";
import SlidersHorizontal from "lucide-react/icons/sliders-horizontal";
import Sparkles from "lucide-react/icons/sparkles";
import Speaker from "lucide-react/icons/speaker";
import Split from "lucide-react/icons/split";
import SplitSquareHorizontal from "lucide-react/icons/split-square-horizontal";
import Sprout from "lucide-react/icons/sprout";
import Square from "lucide-react/icons/square";
import SquareCheck from "lucide-react/icons/square-check";
import SquareDashed from "lucide-react/icons/square-dashed";
import SquarePen from "lucide-react/icons/square-pen";
import SquarePlay from "lucide-react/icons/square-play";
import SquareSplitHorizontal from "lucide-react/icons/square-split-horizontal";
import Star from "lucide-react/icons/star";
import StepForward from "lucide-react/icons/step-forward";
import Sun from "lucide-react/icons/sun";
import SwitchCamera from "lucide-react/icons/switch-camera";
import Swords from "lucide-react/icons/swords";
import Tag from "lucide-react/icons/tag";
import Tags from "lucide-react/icons/tags";
import Tally5 from "lucide-react/icons/tally-5";
import Target from "lucide-react/icons/target";
import Terminal from "lucide-react/icons/terminal";
import Thermometer from "lucide-react/icons/thermometer";
import Timer from "lucide-react/icons/timer";
import TimerOff from "lucide-react/icons/timer-off";
import TimerReset from "lucide-react/icons/timer-reset";
import ToggleLeft from "lucide-react/icons/toggle-left";
import ToggleRight from "lucide-react/icons/toggle-right";
import TowerControl from "lucide-react/icons/tower-control";
import Tractor from "lucide-react/icons/tractor";
import TrafficCone from "lucide-react/icons/traffic-cone";
import TrainFront from "lucide-react/icons/train-front";
import Trash2 from "lucide-react/icons/trash-2";
import Triangle from "lucide-react/icons/triangle";
import TriangleAlert from "lucide-react/icons/triangle-alert";
import Truck from "lucide-react/icons/truck";
import Turtle from "lucide-react/icons/turtle";
import Undo from "lucide-react/icons/undo";
import Undo2 from "lucide-react/icons/undo-2";
import UnfoldHorizontal from "lucide-react/icons/unfold-horizontal";
import UnfoldVertical from "lucide-react/icons/unfold-vertical";
import Unlink from "lucide-react/icons/unlink";
import Upload from "lucide-react/icons/upload";
import User from "lucide-react/icons/user";
import Users from "lucide-react/icons/users";
import Variable from "lucide-react/icons/variable";
import Vibrate from "lucide-react/icons/vibrate";
import Video from "lucide-react/icons/video";
import Volume2 from "lucide-react/icons/volume-2";
import VolumeX from "lucide-react/icons/volume-x";
import Wallet from "lucide-react/icons/wallet";
import Wand from "lucide-react/icons/wand";
import Warehouse from "lucide-react/icons/warehouse";
import Waves from "lucide-react/icons/waves";
import Waypoints from "lucide-react/icons/waypoints";
import Weight from "lucide-react/icons/weight";
import Wifi from "lucide-react/icons/wifi";
import WifiOff from "lucide-react/icons/wifi-off";
import Wind from "lucide-react/icons/wind";
import Workflow from "lucide-react/icons/workflow";
import Wrench from "lucide-react/icons/wrench";
import X from "lucide-react/icons/x";
import Zap from "lucide-react/icons/zap";
import ZapOff from "lucide-react/icons/zap-off";
import ZoomIn from "lucide-react/icons/zoom-in";
import ZoomOut from "lucide-react/icons/zoom-out";

export const ICONS: Readonly<Record<string, LucideIcon>> = {
  activity: Activity,
  "alarm-clock": AlarmClock,
  ampersand: Ampersand,
  ampersands: Ampersands,
  anchor: Anchor,
  antenna: Antenna,
  "app-window": AppWindow,
  archive: Archive,
  "arrow-big-up": ArrowBigUp,
  "arrow-down": ArrowDown,
  "arrow-down-left": ArrowDownLeft,
  "arrow-down-right": ArrowDownRight,
  "arrow-down-to-line": ArrowDownToLine,
  "arrow-left": ArrowLeft,
  "arrow-left-right": ArrowLeftRight,
  "arrow-right": ArrowRight,
  "arrow-right-left": ArrowRightLeft,
  "arrow-up": ArrowUp,
  "arrow-up-0-1": ArrowUp01,
  "arrow-up-down": ArrowUpDown,
  "arrow-up-left": ArrowUpLeft,
  "arrow-up-right": ArrowUpRight,
  "arrow-up-to-line": ArrowUpToLine,
  "audio-lines": AudioLines,
  "badge-alert": BadgeAlert,
  "badge-check": BadgeCheck,
  ban: Ban,
  battery: Battery,
  bell: Bell,
  "bell-dot": BellDot,
  "bell-ring": BellRing,
  "between-horizontal-start": BetweenHorizontalStart,
  bike: Bike,
  binary: Binary,
  binoculars: Binoculars,
  blocks: Blocks,
  bluetooth: Bluetooth,
  bookmark: Bookmark,
  bot: Bot,
  box: Box,
  boxes: Boxes,
  braces: Braces,
  brackets: Brackets,
  brain: Brain,
  brush: Brush,
  bug: Bug,
  calculator: Calculator,
  camera: Camera,
  car: Car,
  check: Check,
  "chevron-down": ChevronDown,
  "chevron-left": ChevronLeft,
  "chevron-right": ChevronRight,
  "chevron-up": ChevronUp,
  "chevrons-down": ChevronsDown,
  "chevrons-left": ChevronsLeft,
  "chevrons-right": ChevronsRight,
  "chevrons-up": ChevronsUp,
  circle: Circle,
  "circle-alert": CircleAlert,
  "circle-arrow-down": CircleArrowDown,
  "circle-arrow-left": CircleArrowLeft,
  "circle-arrow-right": CircleArrowRight,
  "circle-arrow-up": CircleArrowUp,
  "circle-check": CircleCheck,
  "circle-dashed": CircleDashed,
  "circle-dot": CircleDot,
  "circle-gauge": CircleGauge,
  "circle-help": CircleHelp,
  "circle-parking": CircleParking,
  "circle-parking-off": CircleParkingOff,
  "circle-pause": CirclePause,
  "circle-play": CirclePlay,
  "circle-plus": CirclePlus,
  "circle-slash": CircleSlash,
  "circle-slash-2": CircleSlash2,
  "circle-stop": CircleStop,
  "circle-x": CircleX,
  clock: Clock,
  cloud: Cloud,
  code: Code,
  cog: Cog,
  "columns-2": Columns2,
  "columns-3": Columns3,
  compass: Compass,
  construction: Construction,
  container: Container,
  copy: Copy,
  "corner-down-left": CornerDownLeft,
  "corner-down-right": CornerDownRight,
  "corner-up-left": CornerUpLeft,
  "corner-up-right": CornerUpRight,
  cpu: Cpu,
  crosshair: Crosshair,
  diamond: Diamond,
  dices: Dices,
  diff: Diff,
  disc: Disc,
  "disc-3": Disc3,
  "door-closed": DoorClosed,
  "door-open": DoorOpen,
  download: Download,
  droplet: Droplet,
  ellipsis: Ellipsis,
  equal: Equal,
  "equal-not": EqualNot,
  eye: Eye,
  "eye-off": EyeOff,
  factory: Factory,
  fan: Fan,
  file: File,
  "file-code": FileCode,
  "file-plus": FilePlus,
  "file-text": FileText,
  flag: Flag,
  flame: Flame,
  flashlight: Flashlight,
  folder: Folder,
  "folder-open": FolderOpen,
  footprints: Footprints,
  forklift: Forklift,
  "gamepad-2": Gamepad2,
  gauge: Gauge,
  "git-branch": GitBranch,
  "git-fork": GitFork,
  "git-merge": GitMerge,
  globe: Globe,
  grab: Grab,
  "grid-3x3": Grid3x3,
  "grip-vertical": GripVertical,
  hand: Hand,
  hash: Hash,
  heart: Heart,
  hexagon: Hexagon,
  hourglass: Hourglass,
  house: House,
  image: Image,
  inbox: Inbox,
  infinity: InfinityIcon,
  info: Info,
  "iteration-ccw": IterationCcw,
  "iteration-cw": IterationCw,
  joystick: Joystick,
  key: Key,
  keyboard: Keyboard,
  lamp: Lamp,
  "lamp-ceiling": LampCeiling,
  "lamp-desk": LampDesk,
  "land-plot": LandPlot,
  languages: Languages,
  layers: Layers,
  "life-buoy": LifeBuoy,
  lightbulb: Lightbulb,
  "lightbulb-off": LightbulbOff,
  list: List,
  "list-checks": ListChecks,
  loader: Loader,
  locate: Locate,
  lock: Lock,
  "lock-open": LockOpen,
  "log-in": LogIn,
  "log-out": LogOut,
  magnet: Magnet,
  mail: Mail,
  map: Map,
  "map-pin": MapPin,
  maximize: Maximize,
  megaphone: Megaphone,
  menu: Menu,
  "message-circle": MessageCircle,
  mic: Mic,
  milestone: Milestone,
  minus: Minus,
  monitor: Monitor,
  moon: Moon,
  "mouse-pointer-2": MousePointer2,
  move: Move,
  "move-3d": Move3d,
  "move-down": MoveDown,
  "move-left": MoveLeft,
  "move-right": MoveRight,
  "move-up": MoveUp,
  music: Music,
  navigation: Navigation,
  "navigation-2": Navigation2,
  nfc: Nfc,
  "octagon-x": OctagonX,
  package: Package,
  "package-check": PackageCheck,
  "package-minus": PackageMinus,
  "package-open": PackageOpen,
  "package-plus": PackagePlus,
  palette: Palette,
  "panels-top-left": PanelsTopLeft,
  parentheses: Parentheses,
  "parking-circle": ParkingCircle,
  pause: Pause,
  pen: Pen,
  pencil: Pencil,
  percent: Percent,
  pilcrow: Pilcrow,
  pin: Pin,
  plane: Plane,
  play: Play,
  plug: Plug,
  plus: Plus,
  power: Power,
  puzzle: Puzzle,
  rabbit: Rabbit,
  radar: Radar,
  radio: Radio,
  "radio-tower": RadioTower,
  redo: Redo,
  "redo-2": Redo2,
  "refresh-ccw": RefreshCcw,
  "refresh-cw": RefreshCw,
  repeat: Repeat,
  "repeat-1": Repeat1,
  rocket: Rocket,
  "rotate-3d": Rotate3d,
  "rotate-ccw": RotateCcw,
  "rotate-cw": RotateCw,
  route: Route,
  "route-off": RouteOff,
  "rows-2": Rows2,
  "rows-3": Rows3,
  ruler: Ruler,
  save: Save,
  scale: Scale,
  scan: Scan,
  "scan-eye": ScanEye,
  "scan-line": ScanLine,
  search: Search,
  send: Send,
  settings: Settings,
  "settings-2": Settings2,
  shield: Shield,
  ship: Ship,
  shuffle: Shuffle,
  sigma: Sigma,
  signpost: Signpost,
  "signpost-big": SignpostBig,
  siren: Siren,
  "skip-back": SkipBack,
  "skip-forward": SkipForward,
  "sliders-horizontal": SlidersHorizontal,
  sparkles: Sparkles,
  speaker: Speaker,
  split: Split,
  "split-square-horizontal": SplitSquareHorizontal,
  sprout: Sprout,
  square: Square,
  "square-check": SquareCheck,
  "square-dashed": SquareDashed,
  "square-pen": SquarePen,
  "square-play": SquarePlay,
  "square-split-horizontal": SquareSplitHorizontal,
  star: Star,
  "step-forward": StepForward,
  sun: Sun,
  "switch-camera": SwitchCamera,
  swords: Swords,
  tag: Tag,
  tags: Tags,
  "tally-5": Tally5,
  target: Target,
  terminal: Terminal,
  thermometer: Thermometer,
  timer: Timer,
  "timer-off": TimerOff,
  "timer-reset": TimerReset,
  "toggle-left": ToggleLeft,
  "toggle-right": ToggleRight,
  "tower-control": TowerControl,
  tractor: Tractor,
  "traffic-cone": TrafficCone,
  "train-front": TrainFront,
  "trash-2": Trash2,
  triangle: Triangle,
  "triangle-alert": TriangleAlert,
  truck: Truck,
  turtle: Turtle,
  undo: Undo,
  "undo-2": Undo2,
  "unfold-horizontal": UnfoldHorizontal,
  "unfold-vertical": UnfoldVertical,
  unlink: Unlink,
  upload: Upload,
  user: User,
  users: Users,
  variable: Variable,
  vibrate: Vibrate,
  video: Video,
  "volume-2": Volume2,
  "volume-x": VolumeX,
  wallet: Wallet,
  wand: Wand,
  warehouse: Warehouse,
  waves: Waves,
  waypoints: Waypoints,
  weight: Weight,
  wifi: Wifi,
  "wifi-off": WifiOff,
  wind: Wind,
  workflow: Workflow,
  wrench: Wrench,
  x: X,
  zap: Zap,
  "zap-off": ZapOff,
  "zoom-in": ZoomIn,
  "zoom-out": ZoomOut,
};
