"""Tutorials: the steps that a user is asked to do, and whether a program shows that a step is done."""

from kitrobot.tutorial.model import EVENTS, GroupWant, Pattern, Point, SpareWant, Step, TeacherPage, Tutorial
from kitrobot.tutorial.pattern_matcher import fits, steps_fit
from kitrobot.tutorial.tutorial_xml import read_tutorial

__all__ = [
    "EVENTS",
    "GroupWant",
    "Pattern",
    "Point",
    "SpareWant",
    "Step",
    "TeacherPage",
    "Tutorial",
    "fits",
    "read_tutorial",
    "steps_fit",
]
