/** The class as a page of it hears and asks it: its socket is held by the test, requests are answered by `classApi`. */
import { vi } from "vitest";

/** The class's end of the socket of one page. */
class ClassEnd extends EventTarget {
  static readonly OPEN = 1;
  readyState = 1;
  readonly heard: unknown[] = [];

  send(text: string): void {
    if (text !== "?") this.heard.push(JSON.parse(text));
  }
  close(): void {
    this.readyState = 3;
  }
}

export interface ClassWire {
  /** What the page has said, of one type. */
  heard: (type: string) => unknown[];
  open: () => void;
  tell: (message: object) => void;
  lose: () => void;
}

/** Stands in for the line between a page and its class until `vi.unstubAllGlobals`. */
export function holdClassWire(): ClassWire {
  const ends: ClassEnd[] = [];
  vi.stubGlobal(
    "WebSocket",
    class extends ClassEnd {
      constructor() {
        super();
        ends.push(this);
      }
    },
  );
  const last = () => {
    const end = ends.at(-1);
    if (end === undefined) throw new Error("the page has opened no socket");
    return end;
  };
  return {
    heard: (type) => ends.flatMap(({ heard }) => heard).filter((one) => (one as { type: string }).type === type),
    open: () => last().dispatchEvent(new Event("open")),
    tell: (message) => last().dispatchEvent(new MessageEvent("message", { data: JSON.stringify(message) })),
    lose: () => {
      last().close();
      last().dispatchEvent(new Event("close"));
    },
  };
}
