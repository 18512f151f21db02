// scratch-vm on the loop `i+=1; x+=3; act(x); until i=1000`, headless, as fast as it goes:
// turbo mode, the loop in a custom block that runs without screen refresh, frames one after another without a pause.
// `act` is a primitive of its own that keeps the number; a block of an extension would go through one call more.
//
//     node scratch.cjs GIVEN.json RESULT.json        GIVEN: {rounds, laps, until}; RESULT: {seconds: [...]}

const { readFileSync, writeFileSync } = require("node:fs");
const VirtualMachine = require("scratch-vm");

// Seconds of the processor on this thread: what its helpers do meanwhile (compiling, collecting garbage) is free.
const now = () => {
  const { user, system } = process.threadCpuUsage();
  return (user + system) / 1e6;
};

const [givenPath, resultPath] = process.argv.slice(2);
const { rounds, laps, until } = JSON.parse(readFileSync(givenPath, "utf8"));

const NUMBER = 4;
const TEXT = 10;
const VARIABLE = 12;
const literal = (value) => [1, [NUMBER, String(value)]];
const variable = (name) => [3, [VARIABLE, name, name], [TEXT, ""]];
const block = (opcode, parent, next, inputs = {}, fields = {}, mutation = undefined) => ({
  opcode,
  parent,
  next,
  inputs,
  fields,
  mutation,
  shadow: opcode === "procedures_prototype",
  topLevel: parent === null,
});
const procedure = (extra) => ({ tagName: "mutation", children: [], proccode: "loop", argumentids: "[]", warp: "true", ...extra });

const blocks = {
  flag: block("event_whenflagclicked", null, "laps"),
  laps: block("control_repeat", "flag", null, { TIMES: literal(laps), SUBSTACK: [2, "i0"] }),
  i0: block("data_setvariableto", "laps", "x0", { VALUE: literal(0) }, { VARIABLE: ["i", "i"] }),
  x0: block("data_setvariableto", "i0", "call", { VALUE: literal(0) }, { VARIABLE: ["x", "x"] }),
  call: block("procedures_call", "x0", null, {}, {}, procedure({})),
  define: block("procedures_definition", null, "loop", { custom_block: [1, "prototype"] }),
  prototype: block(
    "procedures_prototype", "define", null, {}, {}, procedure({ argumentnames: "[]", argumentdefaults: "[]" }),
  ),
  loop: block("control_repeat_until", "define", null, { CONDITION: [2, "ready"], SUBSTACK: [2, "count"] }),
  ready: block("operator_equals", "loop", null, { OPERAND1: variable("i"), OPERAND2: [1, [TEXT, String(until)]] }),
  count: block("data_changevariableby", "loop", "grow", { VALUE: literal(1) }, { VARIABLE: ["i", "i"] }),
  grow: block("data_changevariableby", "count", "act", { VALUE: literal(3) }, { VARIABLE: ["x", "x"] }),
  act: block("kit_act", "grow", null, { X: variable("x") }),
};

const EMPTY = "0".repeat(32);
const costume = { name: "nothing", dataFormat: "svg", assetId: EMPTY, md5ext: `${EMPTY}.svg`, rotationCenterX: 0, rotationCenterY: 0 };
const target = (name, isStage, more) => ({
  isStage, name, variables: {}, lists: {}, broadcasts: {}, blocks: {}, comments: {}, currentCostume: 0,
  costumes: [costume], sounds: [], volume: 100, ...more,
});
const project = {
  targets: [
    target("Stage", true, { layerOrder: 0, variables: { i: ["i", 0], x: ["x", 0] } }),
    target("Robot", false, { layerOrder: 1, blocks, visible: true, x: 0, y: 0, size: 100, direction: 90, draggable: false, rotationStyle: "all around" }),
  ],
  monitors: [],
  extensions: [],
  meta: { semver: "3.0.0", vm: "0.0.0", agent: "" },
};

async function main() {
  console.log = console.warn = console.error = () => {}; // it says that there is nothing to draw or sound with
  const vm = new VirtualMachine();
  let acted = 0;
  let last = 0;
  vm.runtime._primitives.kit_act = (given) => {
    acted += 1;
    last = given.X;
  };
  vm.extensionManager._loadedExtensions.set("kit", "kit"); // else it would look for that extension
  await vm.loadProject(JSON.stringify(project));
  vm.setTurboMode(true);
  vm.runtime.currentStepTime = 1000 / 30; // a frame is three quarters of this at work
  const seconds = [];
  for (let round = 0; round <= rounds; round += 1) {
    acted = 0;
    vm.greenFlag();
    const begun = now();
    while (vm.runtime.threads.length > 0) vm.runtime._step();
    const taken = now() - begun;
    if (acted !== laps * until || Number(last) !== 3 * until) {
      throw new Error(`scratch-vm acted ${acted} times, at last with ${last}`);
    }
    if (round > 0) seconds.push(taken); // the first round warms up
  }
  writeFileSync(resultPath, JSON.stringify({ seconds }));
  process.exit(0);
}

main().catch((problem) => {
  process.stderr.write(`${problem.stack ?? problem}\n`);
  process.exit(1);
});
