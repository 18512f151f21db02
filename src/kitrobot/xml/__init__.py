"""XML files: reading them through tables of tags, with limits and places; writing them."""

from kitrobot.xml.attributes import (
    ICON,
    NAME,
    TEXT_VALUE,
    YES_NO,
    Attribute,
    Kind,
    decimal,
    needed,
    one,
    optional,
    version,
    whole,
)
from kitrobot.xml.decoder import MAX_BYTES, decode
from kitrobot.xml.element import LONGEST_NAME, Element, Tag
from kitrobot.xml.expat_parser import DoctypeError, ExpatError, new_parser
from kitrobot.xml.foreign import fragment, head, remark
from kitrobot.xml.lessons import lesson_tag, require_label
from kitrobot.xml.reader import MAX_DEPTH, Reader
from kitrobot.xml.texts import LANGUAGE, TEXT, TEXTS, read_text_element, report_duplicate_text
from kitrobot.xml.writer import attributes, escape_text, escape_value, text_element

__all__ = [
    "ICON",
    "LANGUAGE",
    "LONGEST_NAME",
    "MAX_BYTES",
    "MAX_DEPTH",
    "NAME",
    "TEXT",
    "TEXTS",
    "TEXT_VALUE",
    "YES_NO",
    "Attribute",
    "DoctypeError",
    "Element",
    "ExpatError",
    "Kind",
    "Reader",
    "Tag",
    "attributes",
    "decimal",
    "decode",
    "escape_text",
    "escape_value",
    "fragment",
    "head",
    "lesson_tag",
    "needed",
    "new_parser",
    "one",
    "optional",
    "read_text_element",
    "remark",
    "report_duplicate_text",
    "require_label",
    "text_element",
    "version",
    "whole",
]
