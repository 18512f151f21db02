/** What travels over the socket of real robots; the server's models say what each means. */
import type {
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
  BoardStopRequest,
  BoardsWelcomeMessage,
  TeamAgent,
  TeamCancelRequest,
  TeamMessage,
  TeamSendRequest,
} from "../../api/generated";

export type Board = BoardMessage;
export type Port = BoardPort;
export type { TeamAgent };
export type Team = TeamMessage;
export type BoardsMessage =
  BoardsWelcomeMessage | BoardPortsMessage | BoardMessage | BoardGoneMessage | BoardRefusedMessage | TeamMessage;
export type BoardsRequest =
  | BoardsLookRequest
  | BoardConnectRequest
  | BoardSendRequest
  | BoardCancelRequest
  | BoardStartRequest
  | BoardStopRequest
  | BoardIdentifyRequest
  | BoardForgetRequest
  | TeamSendRequest
  | TeamCancelRequest;
