/** What travels over the socket of real robots; the server's models say what each means. */
import type {
  BenchStep as BenchStepOf,
  BoardBenchRequest,
  BoardCancelRequest,
  BoardConnectRequest,
  BoardForgetRequest,
  BoardGoneMessage,
  BoardIdentifyRequest,
  BoardMessage,
  BoardPort,
  BoardPortsMessage,
  BoardRefusedMessage,
  BoardSendRequest,
  BoardsLookRequest,
  BoardStartRequest,
  BoardStepsMessage,
  BoardStopRequest,
  BoardsWelcomeMessage,
  BoardTryRequest,
  TeamAgent,
  TeamCancelRequest,
  TeamMessage,
  TeamSendRequest,
} from "../../api/generated";

export type Board = BoardMessage;
export type Port = BoardPort;
export type BenchStep = BenchStepOf;
export type Steps = BoardStepsMessage;
export type { TeamAgent };
export type Team = TeamMessage;
export type BoardsMessage =
  | BoardsWelcomeMessage
  | BoardPortsMessage
  | BoardMessage
  | BoardGoneMessage
  | BoardRefusedMessage
  | BoardStepsMessage
  | TeamMessage;
export type BoardsRequest =
  | BoardsLookRequest
  | BoardConnectRequest
  | BoardSendRequest
  | BoardBenchRequest
  | BoardTryRequest
  | BoardCancelRequest
  | BoardStartRequest
  | BoardStopRequest
  | BoardIdentifyRequest
  | BoardForgetRequest
  | TeamSendRequest
  | TeamCancelRequest;
