"""Reading `<root BTCPP_format="4">`: the XML of BehaviorTree.CPP 4 and Groot2.

A node's element is named by its kind, by the category of its kind (`<Action ID="…">`), or by its ID alone (`<Drive/>`).
Labels of nodes (`name`) say nothing to a program and are left out, as is what only an editor needs. Left to others:
what nodes mean.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from kitrobot.behaviour_trees import rules
from kitrobot.behaviour_trees.model import MAIN_TREE, NodeModel, TreeFile, TreeNode
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.text.phrases import listed, shown
from kitrobot.text.sentences import Help, Sentence
from kitrobot.xml.attributes import optional
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.reader import Reader

MAX_NODES = 5000
"""Nodes of a tree, at most: an image has room for far fewer actions."""

_PLACED_PORTS = 30
"""Ports of a node whose places are looked up, at most: none of ours has more than a few."""
_CATEGORIES = ("Action", "Condition", "Control", "Decorator")
_FOR_EDITORS = ("ID", "name", "_uid", "_description", "_fullpath")


class _AnyElement(dict[str, Tag]):
    """A table of tags that holds the same tag for each name."""

    def __init__(self, known: Mapping[str, Tag] = {}, other: Tag | None = None) -> None:
        super().__init__(known)
        self.other = other

    def get(self, key: str, default: Any = None) -> Any:
        return super().get(key) or self.other or default


@dataclass(frozen=True)
class _Tree:
    name: str
    root: TreeNode


@dataclass(frozen=True)
class _Port:
    name: str
    default: str


@dataclass(frozen=True)
class _Model:
    name: str
    model: NodeModel


class _Models(tuple[_Model, ...]):
    """The models of a file's nodes."""

    __slots__ = ()


def read_trees(data: bytes, name: str) -> tuple[TreeFile | None, list[Diagnostic]]:
    """Reads a file of behaviour trees; None when it has an error, which the diagnostics tell."""
    reader = Reader(data, name)
    root = reader.read({"root": _ROOT})
    if root is None:
        return None, reader.diagnostics
    trees = {tree.name: tree.root for tree in root.distinct(_Tree, lambda tree: tree.name, "tree")}
    models = {model.name: model.model for several in root.found(_Models) for model in several}
    main = root.optional(MAIN_TREE) or (next(iter(trees)) if len(trees) == 1 else "")
    if not root.faulty and main not in trees:
        _report_main(root, main, list(trees))
    if root.faulty:
        return None, reader.diagnostics
    return TreeFile(trees, main, models), reader.diagnostics


def _report_main(root: Element, main: str, trees: list[str]) -> None:
    help: Help = ""
    if not trees:
        message = Sentence("expected a <BehaviorTree> in <root>, found none")
    elif main:
        message = Sentence("there is no tree {tree} in the file", shown(main))
        help = root.did_you_mean(main, trees) or Sentence("there is {known}", listed(trees))
    else:
        message = Sentence("the file has several trees and does not say which one runs: {trees}", listed(trees))
        help = Sentence("name it on <root>, as in {example}", f'`{MAIN_TREE}="{trees[0][:40]}"`')
    root.report(rules.FORM, message, MAIN_TREE, help)


def _open_root(root: Element) -> None:
    found = root.optional("BTCPP_format")
    if found != "4":
        number = shown(found) if found else Sentence("none")
        root.reader.stop(
            rules.FORM(
                Sentence('expected BTCPP_format="4" on <root>, found {found}', number),
                root.place("BTCPP_format"),
                help=Sentence("save the tree with Groot2, which writes version 4"),
            )
        )


def _open_node(element: Element) -> None:
    reader = element.reader
    count = len(reader.own.setdefault("node", set()))
    if count >= MAX_NODES:
        reader.stop(rules.SIZE(Sentence("expected at most {most} nodes, found one more", MAX_NODES), element.place()))
    reader.own["node"].add(element.start)


def _node(element: Element) -> TreeNode:
    attributes, name, role = element.attributes, element.name, ""
    if name in _CATEGORIES:
        role = name if name in _CATEGORIES[:2] else ""
        name = element.required("ID")
    ports = {key: value for key, value in attributes.items() if key not in _FOR_EDITORS}
    if name == "SubTree":
        ports["ID"] = element.required("ID")
    places = {key: element.place(key) for key in list(ports)[:_PLACED_PORTS]}
    return TreeNode(name, ports, tuple(element.found(TreeNode)), role, element.place(), places)


def _tree(element: Element) -> _Tree | None:
    name, inside = element.required("ID"), element.found(TreeNode)
    if len(inside) != 1:
        element.report(rules.FORM, child_count_message("BehaviorTree", len(inside), 1))
        return None
    return _Tree(name, inside[0])


def child_count_message(name: str, found: int, expected: object) -> Sentence:
    """That a node has another number of nodes inside than it needs."""
    return Sentence(
        "<{node}> has another number of nodes inside: expected {expected}, found {found}", name, expected, found
    )


def _include(element: Element) -> None:
    element.report(
        rules.FORM,
        Sentence("the file brings in {file}, and files inside files are not read", shown(element.optional("path"))),
        "path",
        Sentence("put all trees into one file"),
    )


def _model(element: Element) -> _Model:
    calls = element.found(str)
    defaults = {port.name: port.default for port in element.found(_Port) if port.default}
    return _Model(element.required("ID"), NodeModel(calls[0] if calls else "", defaults))


def _port(element: Element) -> _Port:
    return _Port(element.optional("name"), element.optional("default"))


def _first_call(element: Element) -> str | None:
    calls = element.found(str)
    return calls[0] if calls else None


def _ignored(names: Iterable[str]) -> dict[str, Tag]:
    return {name: Tag(free_attributes=True, text=True) for name in names}


_ANY = {"ID": optional(), "name": optional()}
_NODES = _AnyElement()
_NODE = _NODES.other = Tag(_node, _ANY, _NODES, free_attributes=True, open=_open_node)
_METADATA = Tag(
    _first_call,
    children={"Metadata": Tag(lambda element: element.optional("kitrobot") or None, free_attributes=True)},
)
_MODEL = Tag(
    _model,
    _ANY,
    {
        "input_port": Tag(_port, free_attributes=True, text=True),
        "MetadataFields": _METADATA,
        **_ignored(("output_port", "inout_port", "description")),
    },
    free_attributes=True,
)
_MODELS = Tag(lambda element: _Models(element.found(_Model)), children=_AnyElement(other=_MODEL))
_ROOT = Tag(
    attributes={"BTCPP_format": optional(), MAIN_TREE: optional(), "project_name": optional()},
    children={
        "BehaviorTree": Tag(_tree, _ANY, _NODES, free_attributes=True),
        "TreeNodesModel": _MODELS,
        "include": Tag(_include, free_attributes=True),
    },
    open=_open_root,
)
