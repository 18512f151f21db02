// @vitest-environment jsdom
import { createElement } from "react";
import { renderToStaticMarkup } from "react-dom/server";
import { expect, test } from "vitest";

import type { KitEntry } from "../../api/generated";
import { FirmwareNeed } from "./Firmware";

const KIT: KitEntry = {
  ...{ name: "xrp", label: {}, help: {}, picture: "", absent: {}, file: ".uf2" },
  ...{ micropython: "1.25", firmware: "https://example.org/xrp" },
};

function drawn(has: string, kit = KIT, page = ""): string {
  return renderToStaticMarkup(createElement(FirmwareNeed, { kit, has, page }));
}

test("a kit says what it needs, and whether the board has it", () => {
  expect(drawn("")).toContain('data-met="unknown"');
  expect(drawn("1.24")).toContain('data-met="no"');
  expect(drawn("1.24")).toContain('role="alert"');
  expect(drawn("1.25")).toContain('data-met="yes"');
  expect(drawn("1.25")).not.toContain("href");
});

test("where it is to be had the kit says, else the port, else one page for all", () => {
  expect(drawn("1.2")).toContain('href="https://example.org/xrp"');
  expect(drawn("1.2", { ...KIT, firmware: "" }, "https://example.org/port")).toContain(
    'href="https://example.org/port"',
  );
  expect(drawn("1.2", { ...KIT, firmware: "" })).toContain('href="https://micropython.org/download/"');
  expect(drawn("", { ...KIT, micropython: "" })).toBe("");
});
