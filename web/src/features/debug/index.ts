/** The watch: values of variables and sensors over time; breakpoints that the run follows. */
import { reveal } from "../../session/actions";
import { followBreakpoints } from "../../session/breakpoints";
import type { Feature } from "../../session/features";
import { takeSamples } from "./samples";
import { WatchButton, WatchDock } from "./WatchDock";

export const debug: Feature = {
  name: "debug",
  slots: { below: WatchDock, bottom: WatchButton },
  start: () => {
    const ends = [followBreakpoints(reveal), takeSamples()];
    return () => ends.forEach((end) => end());
  },
};
