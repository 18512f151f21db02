"""Tutorials: what a person is asked to do step by step, and whether a program shows that it is done."""

from kitrobot.tutorial.matching import fits, steps_fit
from kitrobot.tutorial.model import EVENTS, GroupWant, Pattern, Point, SpareWant, Step, TeacherPage, Tutorial
from kitrobot.tutorial.reading import read_tutorial

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
