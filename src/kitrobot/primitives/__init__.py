"""The words a robot understands: constructors and robots, read from XML."""

from kitrobot.primitives.catalogue import SHIPPED, Catalogue, config_folder, load_catalogue
from kitrobot.primitives.constructors import Constructor, ConstructorTable, Group, Role, Slot, SlotKind
from kitrobot.primitives.constructors_xml import read_constructors
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
from kitrobot.primitives.suggestions import Suggestions, did_you_mean, listed, nearest
from kitrobot.primitives.template_xml import Template, read_template
from kitrobot.primitives.templates import Shape, holes, shape
from kitrobot.primitives.unfilling import Bound, fill_with, unfill, unfill_all, unfill_row
from kitrobot.primitives.xml import MAX_DEPTH, TEXT, TEXTS, Reader
from kitrobot.primitives.xml_decoding import MAX_BYTES
from kitrobot.primitives.xml_element import Element, Tag, one_of, shown
from kitrobot.primitives.xml_writing import attributes, escape_text, escape_value, text_element

__all__ = [
    "LARGEST_VALUE",
    "LONGEST_SETTING",
    "MAX_BYTES",
    "MAX_DEPTH",
    "MOST_OWN",
    "MOST_SETTINGS",
    "OWN",
    "OWN_GROUP",
    "SHIPPED",
    "TEXT",
    "TEXTS",
    "Board",
    "Bound",
    "Catalogue",
    "Category",
    "Constructor",
    "ConstructorTable",
    "Element",
    "Group",
    "Kind",
    "Method",
    "OwnVariable",
    "Parameter",
    "Reader",
    "Robot",
    "RobotObject",
    "Role",
    "Shape",
    "Slot",
    "SlotKind",
    "Suggestions",
    "Tag",
    "Template",
    "Texts",
    "ValueType",
    "attributes",
    "config_folder",
    "did_you_mean",
    "escape_text",
    "escape_value",
    "fill_with",
    "holes",
    "listed",
    "load_catalogue",
    "nearest",
    "one_of",
    "read_constructors",
    "read_own",
    "read_robot",
    "read_template",
    "shape",
    "shown",
    "text_element",
    "unfill",
    "unfill_all",
    "unfill_row",
    "write_constructor",
    "write_constructors",
    "write_variable",
]
