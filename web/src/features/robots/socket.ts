/**
 * The socket to the server's robots. It is opened when somebody first wants a robot and stays as long as one is held or the panel
 * is open; when it closes, the server lets the robots go, and those that are held stop.
 */
import { create } from "zustand";

import { socketAddress } from "../../api/address";
import { transport } from "../../api/transport";
import { t } from "../../i18n/words";
import { boardsConnecting, boardsLost, takeMessage } from "./boards";
import { setStopAll } from "./state";
import type { BoardsMessage, BoardsRequest } from "./wire";

interface Connection {
  socket: WebSocket | null;
  /** What is sent as soon as it is open. */
  waiting: readonly BoardsRequest[];
}

const NONE: Connection = { socket: null, waiting: [] };
const useConnection = create(() => NONE);

/** Why the connection ended: refused before it began, or broken. */
function lost(): void {
  useConnection.setState(NONE);
  boardsLost({ message: t("boards.server-lost"), help: t("boards.server-lost-help"), problems: [] });
}

/** Opens the socket, if it is not. */
export function connect(): void {
  if (useConnection.getState().socket !== null) return;
  const opened = transport().socket(socketAddress("api/boards"));
  useConnection.setState({ socket: opened });
  boardsConnecting();
  setStopAll(() => send({ type: "stop", address: "" }));
  opened.addEventListener("open", () => {
    for (const request of useConnection.getState().waiting) opened.send(JSON.stringify(request));
    useConnection.setState({ waiting: [] });
  });
  opened.addEventListener("message", (event: MessageEvent<string>) => {
    if (useConnection.getState().socket !== opened) return;
    takeMessage(JSON.parse(event.data) as BoardsMessage);
  });
  opened.addEventListener("close", () => {
    if (useConnection.getState().socket === opened) lost();
  });
}

export function send(request: BoardsRequest): void {
  connect();
  const { socket, waiting } = useConnection.getState();
  if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(request));
  else useConnection.setState({ waiting: [...waiting, request] });
}
