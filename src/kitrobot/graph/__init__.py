"""A program as a graph, and its part of the `.krt` file."""

from kitrobot.graph.graph_xml import PROGRAM, write_program
from kitrobot.graph.model import IN, NEXT, RETURN, START, STOP, Arc, Note, Program, Vertex, empty_program

__all__ = [
    "IN",
    "NEXT",
    "PROGRAM",
    "RETURN",
    "START",
    "STOP",
    "Arc",
    "Note",
    "Program",
    "Vertex",
    "empty_program",
    "write_program",
]
