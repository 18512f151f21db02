// Blockly as a page: one workspace, its code beside it, written anew after every change.
//
// The page is given `given.json` ({definitions, workspace}) and offers what a measurement asks for as `window.peer`.
/* global Blockly, javascript */

const peer = { ready: false, code: 0 };
window.peer = peer;

async function begin() {
  const { definitions, workspace: state } = await (await fetch("given.json")).json();
  const { javascriptGenerator } = javascript;
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
  javascriptGenerator.forBlock["kit_wait"] = (block) => `wait(${block.getFieldValue("duration")});\n`;
  javascriptGenerator.forBlock["kit_when"] = (block, generator) =>
    `when(() => ${generator.valueToCode(block, "CONDITION", 99) || "false"});\n${generator.statementToCode(block, "DO")}`;

  const workspace = Blockly.inject("blocks", { move: { wheel: true }, zoom: { wheel: false }, sounds: false, media: "media/" });
  Blockly.Events.disable();
  Blockly.serialization.workspaces.load(state, workspace);
  Blockly.Events.enable();
  await Blockly.renderManagement.finishQueuedRenders();
  const shown = document.getElementById("code");
  const write = () => {
    shown.textContent = javascriptGenerator.workspaceToCode(workspace);
    peer.code += 1;
  };
  write();
  peer.code = 0;
  workspace.addChangeListener((event) => {
    if (!event.isUiEvent) write();
  });

  // A block into the middle of the first stack, as a drop would put it.
  peer.insert = async () => {
    const [first] = workspace.getTopBlocks(true);
    const after = first.getNextBlock() ?? first;
    const block = workspace.newBlock("kit_wait");
    block.initSvg();
    block.queueRender();
    after.nextConnection.connect(block.previousConnection);
    await Blockly.renderManagement.finishQueuedRenders();
  };
  // The number of a block of the first stack, as its field would set it.
  const number = workspace.getAllBlocks(true).flatMap((block) => {
    const field = block.getField("speed") ?? block.getField("duration") ?? block.getField("TIMES");
    return field === null ? [] : [field];
  })[0];
  peer.change = (value) => number.setValue(value);
  peer.fit = () => workspace.zoomToFit();
  peer.blocks = () => workspace.getAllBlocks(false).length;
  peer.ready = true;
}

void begin();
