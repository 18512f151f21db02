/**
 * The arena as a stage, fetched when it is made large or something runs: its size, what it shows besides the robots (trails,
 * rays, radio, the way ahead), the robot that is watched, sound, and how the run ended.
 */
import "./stage.css";
// The menu of a robot is asked for while something runs: its keys are pressed as soon as it opens.
import "../RobotMenu";

export { EndCard } from "./EndCard";
export { openShown } from "./shown-menu";
export { Shown } from "./Shown";
export { Switches } from "./Switches";
export { toggle } from "./size";
export { RobotReadings } from "./RobotReadings";
