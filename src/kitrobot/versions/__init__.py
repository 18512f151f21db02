"""Versions of a mission or a kit held against each other: what is different, in words, and three-way merges."""

from kitrobot.versions.comparison import (
    CompareError,
    Difference,
    compare_files,
    differences,
    kit_whole,
    mission_whole,
    text_differences,
)
from kitrobot.versions.conflicts import Conflict
from kitrobot.versions.kit_merge import merge_kits
from kitrobot.versions.kits import kit_differences
from kitrobot.versions.mission_merge import Merged, merge_missions

__all__ = [
    "CompareError",
    "Conflict",
    "Difference",
    "Merged",
    "compare_files",
    "differences",
    "kit_differences",
    "kit_whole",
    "merge_kits",
    "merge_missions",
    "mission_whole",
    "text_differences",
]
