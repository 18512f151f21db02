// Blockly, headless: JSON text → workspace (load), workspace → JavaScript (generate).
// Events are off while it loads, which is faster; blocks of the robot hold their numbers in fields, not in blocks.
//
//     node blockly.cjs GIVEN.json RESULT.json
//         GIVEN: {rounds, definitions, workspace: JSON text, blocks: how many it holds}
//         RESULT: {load: [seconds], generate: [seconds]}

const { readFileSync, writeFileSync } = require("node:fs");
const Blockly = require("blockly");
const { javascriptGenerator } = require("blockly/javascript");

// Seconds of the processor on this thread: what its helpers do meanwhile (compiling, collecting garbage) is free.
const now = () => {
  const { user, system } = process.threadCpuUsage();
  return (user + system) / 1e6;
};

const [givenPath, resultPath] = process.argv.slice(2);
const { rounds, definitions, workspace: text, blocks } = JSON.parse(readFileSync(givenPath, "utf8"));

Blockly.defineBlocksWithJsonArray(definitions);
for (const { type, call, args0 = [], output } of definitions) {
  javascriptGenerator.forBlock[type] = (block, generator) => {
    const given = args0.map(({ type: kind, name }) =>
      kind === "field_number" ? String(block.getFieldValue(name)) : generator.valueToCode(block, name, 99) || "0",
    );
    const code = `${call}(${given.join(", ")})`;
    return output === undefined ? `${code};\n` : [code, 1];
  };
}
for (const [type, word] of [["kit_wait", "wait"], ["kit_when", "when"]]) {
  javascriptGenerator.forBlock[type] = (block, generator) =>
    type === "kit_wait"
      ? `${word}(${block.getFieldValue("duration")});\n`
      : `${word}(() => ${generator.valueToCode(block, "CONDITION", 99) || "false"});\n${generator.statementToCode(block, "DO")}`;
}

const result = { load: [], generate: [] };
for (let round = 0; round <= rounds; round += 1) {
  const workspace = new Blockly.Workspace();
  Blockly.Events.disable();
  const begun = now();
  Blockly.serialization.workspaces.load(JSON.parse(text), workspace);
  const loaded = now();
  const code = javascriptGenerator.workspaceToCode(workspace);
  const generated = now();
  Blockly.Events.enable();
  const found = workspace.getAllBlocks(false).length;
  if (found !== blocks || code.split("\n").length < blocks / 2) {
    throw new Error(`Blockly loaded ${found} blocks of ${blocks} and wrote ${code.split("\n").length} lines`);
  }
  workspace.dispose();
  if (round > 0) {
    // the first round warms up
    result.load.push(loaded - begun);
    result.generate.push(generated - loaded);
  }
}
writeFileSync(resultPath, JSON.stringify(result));
process.exit(0);
