"""Translations: graph → LLL, LLL → graph, LLL → three-address code → image; and the check of a program's names."""

from kitrobot.compiler.checker import check
from kitrobot.compiler.compilation import (
    CheckResult,
    Compiled,
    compile_lll,
    compile_program,
    compile_text,
    not_compiled,
)
from kitrobot.compiler.expansion_limit import left_out, oversize_in_mission
from kitrobot.compiler.graph_to_lll import Translation, graph_to_lll
from kitrobot.compiler.lll_to_graph import lll_to_graph
from kitrobot.compiler.own_part import Appearance, ChosenSlot, Part, PartError, PartOffer, make_part, offer_part
from kitrobot.compiler.part_offers import Offer
from kitrobot.compiler.part_text import PartText, draw_template, read_part
from kitrobot.compiler.projection import Projection, project
from kitrobot.compiler.selection import SelectionError
from kitrobot.compiler.target import Read, Target, print_for, read_for, robot_of, target_of
from kitrobot.compiler.team_check import check_program, program_circles
from kitrobot.compiler.team_compilation import CompiledTeam, compile_team
from kitrobot.compiler.team_names import check_declarations
from kitrobot.compiler.team_points import ALL, ONE, Point, PointKind, TeamPlan
from kitrobot.compiler.text_edit import Followed, follow_text
from kitrobot.compiler.vertex_places import VertexPlace, vertex_places

__all__ = [
    "ALL",
    "ONE",
    "Appearance",
    "CheckResult",
    "ChosenSlot",
    "Compiled",
    "CompiledTeam",
    "Followed",
    "Offer",
    "Part",
    "PartError",
    "PartOffer",
    "PartText",
    "Point",
    "PointKind",
    "Projection",
    "Read",
    "SelectionError",
    "Target",
    "TeamPlan",
    "Translation",
    "VertexPlace",
    "check",
    "check_declarations",
    "check_program",
    "compile_lll",
    "compile_program",
    "compile_team",
    "compile_text",
    "draw_template",
    "follow_text",
    "graph_to_lll",
    "left_out",
    "lll_to_graph",
    "make_part",
    "not_compiled",
    "offer_part",
    "oversize_in_mission",
    "print_for",
    "program_circles",
    "project",
    "read_for",
    "read_part",
    "robot_of",
    "target_of",
    "vertex_places",
]
