/**
 * The features of the page: the only list of them. Adding one is adding its folder and a line here.
 *
 * Where several stand side by side (slots, a group of a menu, tabs) they do so in this order; where one gets another as its
 * `children` (panels) it comes after that.
 */
import { accessibility } from "../features/accessibility";
import { arena } from "../features/arena";
import { canvas } from "../features/canvas";
import { check } from "../features/check";
import { classroom } from "../features/class";
import { code } from "../features/code";
import { customBlocks } from "../features/custom-blocks";
import { debug } from "../features/debug";
import { exercise } from "../features/exercise";
import { experiment } from "../features/experiment";
import { exporting } from "../features/export";
import { gallery } from "../features/gallery";
import { importFiles } from "../features/import-files";
import { inspector } from "../features/inspector";
import { learn } from "../features/learn";
import { newMission } from "../features/new-mission";
import { palette } from "../features/palette";
import { problems } from "../features/problems";
import { robots } from "../features/robots";
import { run } from "../features/run";
import { sweep } from "../features/sweep";
import { team } from "../features/team";
import { tutorial } from "../features/tutorial";
import { world } from "../features/world";
import { type Feature, install } from "../session/features";
import { page } from "./page";

export const FEATURES: readonly Feature[] = [
  page,
  palette,
  canvas,
  inspector,
  code,
  arena,
  problems,
  debug,
  team,
  run,
  sweep,
  experiment,
  check,
  robots,
  world,
  newMission,
  gallery,
  learn,
  tutorial,
  exercise,
  classroom,
  importFiles,
  exporting,
  accessibility,
  customBlocks,
];

install(FEATURES);
