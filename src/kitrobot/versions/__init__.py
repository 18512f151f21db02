"""Versions of a mission or a kit held against each other: what is different, in words, and three-way merges."""

from kitrobot.versions.comparison import CompareError, Difference, compare_files, differences, text_differences
from kitrobot.versions.conflicts import Conflict
from kitrobot.versions.kit_merging import merge_kits
from kitrobot.versions.kits import kit_differences
from kitrobot.versions.merged_files import merge_files
from kitrobot.versions.merging import Merged, merge_missions

__all__ = [
    "CompareError",
    "Conflict",
    "Difference",
    "Merged",
    "compare_files",
    "differences",
    "kit_differences",
    "merge_files",
    "merge_kits",
    "merge_missions",
    "text_differences",
]
