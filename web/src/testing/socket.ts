/** The line to the server as tests want it: sockets that keep what is sent, answers that the test gives. */
import { setTransport, transport } from "../api/transport";

export class Socket extends EventTarget {
  readonly sent: unknown[] = [];
  readyState: number = WebSocket.OPEN;
  send(text: string): void {
    this.sent.push(JSON.parse(text));
  }
  close(): void {
    this.readyState = WebSocket.CLOSED;
  }
  /** The server takes the connection. */
  open(): void {
    this.dispatchEvent(new Event("open"));
  }
  /** A message of the server. */
  say(message: unknown): void {
    this.dispatchEvent(new MessageEvent("message", { data: JSON.stringify(message) }));
  }
  /** The connection breaks. */
  lose(): void {
    this.readyState = WebSocket.CLOSED;
    this.dispatchEvent(new Event("close"));
  }
}

export interface TestLine {
  /** Addresses that were asked, with what was sent. */
  asked: [string, unknown][];
  /** What is answered, by the address without its query, or made of what was sent; a Response as it is, else as JSON. */
  answers: Record<string, unknown>;
  sockets: Socket[];
  end: () => void;
}

type Answer = (sent: unknown) => unknown;

/** The server refuses with these words. */
export function refusal(message: string, help = "", status = 422): Response {
  return new Response(JSON.stringify({ message, help }), { status });
}

/** Talks to nobody from now on. */
export function testLine(answers: Record<string, unknown> = {}): TestLine {
  const usual = transport();
  const line: TestLine = { asked: [], answers, sockets: [], end: () => setTransport(usual) };
  setTransport({
    fetch: (address, init) => {
      line.asked.push([address, init.body]);
      const given = line.answers[address.split("?")[0] ?? ""];
      const answer =
        typeof given === "function"
          ? (given as Answer)(JSON.parse(typeof init.body === "string" ? init.body : "null"))
          : given;
      return Promise.resolve(answer instanceof Response ? answer.clone() : new Response(JSON.stringify(answer ?? {})));
    },
    socket: () => {
      const socket = new Socket();
      line.sockets.push(socket);
      return socket as unknown as WebSocket;
    },
  });
  return line;
}
