"""Writing a behaviour tree, and the robot's calls as the palette of Groot2.

Each leaf is written with its category (`<Action ID="…">`), so that every reader knows it; `TreeNodesModel` holds all
procedures and tests of the robot with their ports, and says which call each stands for.
"""

from __future__ import annotations

from kitrobot.behaviour_trees.calls import call_ids
from kitrobot.behaviour_trees.model import MAIN_TREE, TreeNode
from kitrobot.primitives.robot import Kind, Robot
from kitrobot.xml.writer import attributes


def write_tree(root: TreeNode, name: str, robot: Robot) -> str:
    """The text of a file with one tree, whose ID is `name`."""
    lines = ['<?xml version="1.0" encoding="UTF-8"?>']
    lines.append(f"<root{attributes(('BTCPP_format', 4), (MAIN_TREE, name))}>")
    lines.append(f"  <BehaviorTree{attributes(('ID', name))}>")
    _write_node(root, "    ", lines)
    lines += ["  </BehaviorTree>", "  <TreeNodesModel>"]
    ids = call_ids(robot)
    for (part, method), (_, meant) in robot.calls.items():
        if meant.kind is not Kind.VALUE:
            inside = [
                f"      <input_port{attributes(('name', one.name), ('type', 'int'), ('default', one.default))}/>"
                for one in meant.parameters
            ]
            call = f"<Metadata{attributes(('kitrobot', f'{part}.{method}'))}/>"
            inside.append(f"      <MetadataFields>{call}</MetadataFields>")
            role = "Condition" if meant.kind is Kind.TEST else "Action"
            _write_element(f"{role}{attributes(('ID', ids[part, method]))}", role, inside, "    ", lines)
    return "\n".join([*lines, "  </TreeNodesModel>", "</root>", ""])


def _write_node(node: TreeNode, indent: str, lines: list[str]) -> None:
    element = node.role or node.name
    named = (("ID", node.name),) if node.role else ()
    inside: list[str] = []
    for child in node.children:
        _write_node(child, f"{indent}  ", inside)
    _write_element(f"{element}{attributes(*named, *node.ports.items())}", element, inside, indent, lines)


def _write_element(start: str, element: str, inside: list[str], indent: str, lines: list[str]) -> None:
    if inside:
        lines += [f"{indent}<{start}>", *inside, f"{indent}</{element}>"]
    else:
        lines.append(f"{indent}<{start}/>")
