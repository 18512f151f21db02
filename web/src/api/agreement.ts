/**
 * Holds the page's types against the server's: this file compiles only while they agree.
 *
 * What the server sends must fit the page's types, what the page sends must fit the server's. Nothing here is ever run.
 */
import type * as server from "./generated";
import type { DrawnProgram, SentMission } from "./known";
import type { Made, MissionEntry, Saved, Session } from "./client";
import type { Recording, RecordingEntry } from "./traces";
import type { Tutorial, TutorialFit } from "./tutorials";
import type { Fragment, Mission, MissionFile, Report } from "./types";
import type { RunMessage, RunRequest } from "./wire";

type Fits<Wanted, Given extends Wanted> = Given;

export type Received = [
  Fits<Session, server.Session>,
  Fits<MissionEntry, server.MissionEntry>,
  Fits<MissionFile, server.MissionFile>,
  Fits<Report, server.Report>,
  Fits<Fragment, server.Fragment>,
  Fits<DrawnProgram, server.DrawnProgram>,
  Fits<Saved, server.Saved>,
  Fits<Made, server.Image>,
  Fits<RunMessage, server.RunMessage>,
  Fits<Recording, server.Recording>,
  Fits<RecordingEntry, server.RecordingEntry>,
  Fits<Tutorial, server.Tutorial>,
  Fits<TutorialFit, server.TutorialFit>,
];

export type Sent = [
  Fits<server.Mission, Mission>,
  Fits<server.SentMission, SentMission>,
  Fits<server.RunRequest, RunRequest>,
];
