"""From a drawn program to one that runs: graph → checked, verified image, against Blockly's blocks → JavaScript.

The same program on both sides: as many blocks as vertices (Start and Stop apart). Ours reads structure off the arcs,
checks every name, number and path, writes the LLL, and makes an image and its debug map; verifying the image is
counted. Blockly loads its JSON into a workspace without a screen and generates JavaScript, which nobody parses yet. Not
counted: making the program, starting Node, loading Blockly and the robot's XML, one round of each to warm up.
"""

from __future__ import annotations

import json
from dataclasses import dataclass

from benchmarks.measurement import Rate, Row, in_turns
from benchmarks.peers import blockly, node
from benchmarks.random_programs import ROBOT, catalogue, graph_of, tree_of_vertices
from kitrobot.compiler.compilation import compile_program
from kitrobot.graph.model import Program
from kitrobot.image.verification import verify
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission

TITLE = "compiling"


@dataclass(frozen=True)
class Size:
    vertices: int
    rounds: int


FULL = Size(10_000, 7)
TINY = Size(40, 1)


def run(size: Size, *, peers: bool) -> list[Row]:
    tree = tree_of_vertices(size.vertices)
    graph = graph_of(tree)
    assert len(graph.vertices) == size.vertices
    text = write_mission(Mission(programs=[graph]))

    def compile_graph(program: Program) -> None:
        compiled = compile_program(program, catalogue())
        assert compiled.image is not None, [item.message for item in compiled.diagnostics]
        verify(compiled.image)

    def compile_text() -> None:
        mission, _ = read_mission(text, "measured.krt")
        assert mission is not None
        compile_graph(mission.programs[0])

    seconds = in_turns({"text": compile_text, "graph": lambda: compile_graph(graph)}, size.rounds)
    whole = Rate.of(size.vertices, seconds["text"])
    part = Rate.of(size.vertices, seconds["graph"])

    robot = catalogue().robot(ROBOT)
    state, blocks = blockly.workspace(tree, robot)
    assert blocks == size.vertices - 2
    given = {
        "rounds": size.rounds,
        "definitions": blockly.definitions(robot, tree),
        "workspace": json.dumps(state),
        "blocks": blocks,
    }
    theirs = node.run_peer("blockly.cjs", given) if peers else None
    name = f"Blockly {node.version('blockly')}" if theirs else ""
    generating = Rate.of(blocks, theirs["generate"]) if theirs else None
    both = (
        Rate.of(blocks, [load + generate for load, generate in zip(theirs["load"], theirs["generate"], strict=True)])
        if theirs
        else None
    )
    return [
        Row("graph in memory → image, generating alone", "vertices/s", part, name, generating),
        Row("graph in memory → image", "vertices/s", part, name, both),
        Row(".krt text → image", "vertices/s", whole, name, both),
    ]
