import { afterEach, beforeEach, describe, expect, it } from "vitest";

import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useRun } from "../../session/run";
import type { RunAgent } from "../../session/run-state";
import { follows, restFollowing, toggleFollowing, useView, type Viewport } from "../../session/view";
import { mount, type Mounted } from "../../testing/hooks";
import { ActiveVertices } from "./active";

let page: Mounted;
let seen: string[];

/** The first agent stands on that vertex, the run having begun. */
function stands(vertex: string): void {
  const agent = { name: "c-1", program: "carrier", active: [[0, vertex]] } as unknown as RunAgent;
  page.act(() => useRun.setState({ status: "running", agents: [agent] }));
}
function begin(): void {
  page.act(() => useRun.setState({ status: "connecting", agents: [] }));
}

beforeEach(() => {
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  seen = [];
  useView.setState({ viewport: { reveal: (id: string) => seen.push(id) } as unknown as Viewport });
  page = mount(<ActiveVertices program="carrier" />);
  begin();
});
afterEach(() => {
  page.end();
  useRun.setState({ status: "idle", agents: [] });
  useView.setState({ viewport: null, following: true, resting: false, noting: null });
});

describe("the vertex that runs", () => {
  it("stays in view unasked", () => {
    stands("v3");
    stands("v4");
    expect(seen).toEqual(["v3", "v4"]);
  });

  it("is not followed once the canvas was moved by hand, until the next run", () => {
    stands("v3");
    restFollowing();
    stands("v4");
    expect([seen, follows(useView.getState())]).toEqual([["v3"], false]);
    begin();
    stands("v6");
    expect(seen).toEqual(["v3", "v6"]);
  });

  it("is followed again at once when that is switched on", () => {
    stands("v3");
    restFollowing();
    stands("v4");
    page.act(toggleFollowing);
    expect(seen).toEqual(["v3", "v4"]);
  });

  it("is not followed in the next run either where that is switched off", () => {
    page.act(toggleFollowing);
    begin();
    stands("v3");
    expect(seen).toEqual([]);
  });

  it("is not followed while somebody writes at another", () => {
    useView.setState({ noting: "v1" });
    stands("v3");
    expect(seen).toEqual([]);
  });
});
