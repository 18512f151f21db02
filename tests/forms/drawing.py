"""Graphs by hand, one arc a word: `loop.body>step` leaves `loop` at `body`; `step>loop@return` comes back to it."""

from __future__ import annotations

from kitrobot.graph.model import START, STOP, Arc, Program, Vertex


def draw(robot: str, vertices: dict[str, str], arcs: str) -> Program:
    """A program of Start, Stop and the given vertices: id → `Element` or `Element name=value name=value`."""
    made = [Vertex("start", START)]
    for vertex, written in vertices.items():
        # A constructor's name may hold spaces; a setting always holds a `=`.
        words = written.split(" ")
        settings = dict(word.split("=") for word in words if "=" in word)
        made.append(Vertex(vertex, " ".join(word for word in words if "=" not in word), settings))
    made.append(Vertex("stop", STOP))
    return Program("drawn", robot, made, [arc(word) for word in arcs.split()])


def arc(word: str) -> Arc:
    source, target = word.split(">")
    source, _, out = source.partition(".")
    target, _, at = target.partition("@")
    return Arc(source, target, out or "next", at or "in")
