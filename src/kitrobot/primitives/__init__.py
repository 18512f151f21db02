"""The words a robot understands: constructors and robots, read from XML."""

from kitrobot.primitives.attribute_kinds import IDENTIFIER, LEVEL
from kitrobot.primitives.automatic import DONE, TAKE, number_variable, work_object
from kitrobot.primitives.catalogue import SHIPPED, Catalogue, load_catalogue
from kitrobot.primitives.constructors import Constructor, ConstructorTable, Group, Role, Slot, SlotKind
from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.crew import Crew, CrewProgram, declaring, team_robot
from kitrobot.primitives.kit import (
    OF_A_TEAM,
    Kit,
    KitPart,
    Measured,
    Module,
    Source,
    Tried,
    Wire,
    as_measured,
    lacks,
    on_kit,
)
from kitrobot.primitives.kit_xml import KIT_SUFFIX, read_kit, write_kit
from kitrobot.primitives.levels import Level
from kitrobot.primitives.match_template import Bound, fill_with, unfill, unfill_all, unfill_row
from kitrobot.primitives.meaning import Choice, Meaning
from kitrobot.primitives.own_xml import (
    MOST_OWN,
    OWN,
    OWN_GROUP,
    OwnVariable,
    read_own,
    write_constructor,
    write_constructors,
    write_variable,
)
from kitrobot.primitives.robot import (
    LARGEST_VALUE,
    LONGEST_SETTING,
    MOST_SETTINGS,
    Board,
    Category,
    Kind,
    Method,
    Parameter,
    Robot,
    RobotObject,
    Texts,
    ValueType,
)
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.primitives.team_objects import TEAM, has_team, with_team
from kitrobot.primitives.template_xml import Template, read_template
from kitrobot.primitives.templates import Shape, holes, shape
from kitrobot.primitives.value_format import format_value, held_by_hand, in_words, set_by_hand

__all__ = [
    "DONE",
    "IDENTIFIER",
    "KIT_SUFFIX",
    "LARGEST_VALUE",
    "LEVEL",
    "LONGEST_SETTING",
    "MOST_OWN",
    "MOST_SETTINGS",
    "OF_A_TEAM",
    "OWN",
    "OWN_GROUP",
    "SHIPPED",
    "TAKE",
    "TEAM",
    "Board",
    "Bound",
    "Catalogue",
    "Category",
    "Choice",
    "Constructor",
    "ConstructorTable",
    "Crew",
    "CrewProgram",
    "Group",
    "Kind",
    "Kit",
    "KitPart",
    "Level",
    "Meaning",
    "Measured",
    "Method",
    "Module",
    "OwnVariable",
    "Parameter",
    "Robot",
    "RobotObject",
    "Role",
    "Shape",
    "Slot",
    "SlotKind",
    "Source",
    "Template",
    "Texts",
    "Tried",
    "ValueType",
    "Wire",
    "as_measured",
    "declaring",
    "fill_with",
    "format_value",
    "has_team",
    "held_by_hand",
    "holes",
    "in_words",
    "lacks",
    "load_catalogue",
    "number_variable",
    "on_kit",
    "read_constructors",
    "read_kit",
    "read_own",
    "read_robot",
    "read_template",
    "set_by_hand",
    "shape",
    "team_robot",
    "unfill",
    "unfill_all",
    "unfill_row",
    "with_team",
    "work_object",
    "write_constructor",
    "write_constructors",
    "write_kit",
    "write_variable",
]
