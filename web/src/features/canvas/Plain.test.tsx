/** Vertices from far away: blocks without words, which are selected, have a name for screen readers, and show trouble. */
import { afterEach, beforeEach, expect, it } from "vitest";

import { layoutStructure } from "../../model/layout";
import { partsOf } from "../../model/parts";
import { readStructure } from "../../model/structure";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { PARTS } from "../../model/testing/parts";
import { mount, type Mounted } from "../../testing/hooks";
import { CameraContext, createCamera } from "./camera";
import { PLAIN_ZOOM, PlainNode, usePlain } from "./Plain";

const { nodes } = layoutStructure(readStructure(CARRIER, partsOf(PARTS, "carrier")));
let page: Mounted;
const blocks = () => [...page.place.querySelectorAll<HTMLElement>(".plain")];
const block = (id: string) => page.place.querySelector<HTMLElement>(`#vertex-${id}`);

beforeEach(() => {
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  page = mount(nodes.map((node, at) => <PlainNode key={at} node={node} />));
});
afterEach(() => page.end());

it("each node is a block without words, with a name for screen readers", () => {
  expect(blocks()).toHaveLength(nodes.length);
  expect(page.place.textContent).toBe("");
  expect(blocks().filter((one) => !one.getAttribute("aria-label"))).toEqual([]);
});

it("a click selects a block", () => {
  page.act(() => block("v8")?.click());
  expect(block("v8")?.getAttribute("aria-current")).toBe("true");
  expect(useStudio.getState().selection).toEqual(["v8"]);
});

it("a mistake is seen on its block", () => {
  const where = { file: "", line: 1, column: 1, end_line: 1, end_column: 1, severity: "error" as const, code: "c" };
  const problem = { ...where, message: "m", help: "", program: "carrier", vertices: ["v8"], arcs: [], fix: null };
  expect(page.place.querySelectorAll(".plain-trouble")).toHaveLength(0);
  page.act(() => useStudio.getState().setReport({ programs: [], problems: [problem] }));
  expect(block("v8")?.querySelector<HTMLElement>(".plain-trouble")?.dataset["severity"]).toBe("error");
  expect(page.place.querySelectorAll(".plain-trouble")).toHaveLength(1);
});

it("it is far away below a zoom at which words are too small to be read", () => {
  const camera = createCamera({ x: 0, y: 0, zoom: PLAIN_ZOOM }, { width: 400, height: 300 });
  const Probe = () => <p>{String(usePlain())}</p>;
  const probe = mount(
    <CameraContext value={camera}>
      <Probe />
    </CameraContext>,
  );
  expect(probe.place.textContent).toBe("false");
  probe.act(() => camera.store.setState({ zoom: PLAIN_ZOOM - 0.01 }));
  expect(probe.place.textContent).toBe("true");
  probe.end();
});
