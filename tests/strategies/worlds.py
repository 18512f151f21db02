"""Random worlds as people draw them in the studio: what is in them may well not fit together."""

from __future__ import annotations

from typing import Any

from hypothesis import strategies as st

from kitrobot.translation.languages import TEXT_LANGUAGES
from kitrobot.world.geometry import Corner, Pose
from kitrobot.world.model import (
    COLOURS,
    LEFT,
    LOAD,
    RIGHT,
    UNLOAD,
    ZONE_KINDS,
    Ball,
    Box,
    ColouredLine,
    Dock,
    Floor,
    Road,
    Section,
    Start,
    Storehouse,
    Wall,
    World,
    Zone,
)

names = st.text(alphabet="aZ09-_. é“<&'\"", min_size=1, max_size=6).filter(lambda name: name.strip() == name)
labels = names.map(lambda name: " ".join(name.split()))
"""A reader takes white space as one space."""
places = st.integers(-1_000_000, 3_000_000).map(lambda thousandths: thousandths / 1000)
lengths = st.integers(1_000, 900_000).map(lambda thousandths: thousandths / 1000)
counts = st.integers(0, 40)
colours = st.sampled_from(sorted(COLOURS))
corners = st.builds(Corner, places, places, st.one_of(st.just(0.0), lengths))
lines = st.lists(corners, min_size=0, max_size=4).map(tuple)


@st.composite
def _roads(draw: st.DrawFn) -> Road:
    cuts = sorted(draw(st.lists(lengths, max_size=3, unique=True)))
    sections = tuple(
        Section(draw(counts), start, end)
        for start, end in zip([0.0, *cuts], [*cuts, float("inf")], strict=True)
        if cuts
    )
    return Road(draw(names), draw(lengths), draw(st.booleans()), draw(lines), sections)


def _distinct(part: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    return st.lists(part, max_size=3, unique_by=lambda one: one.name).map(tuple)


starts = st.one_of(
    st.builds(Start, names, road=names, at_mm=lengths),
    st.builds(Start, names, dock=names),
    st.builds(Start, names, storehouse=names),
    st.builds(Start, names, pose=st.builds(Pose, places, places, st.just(0.0))),
)

kinds_of_zones = st.sampled_from(ZONE_KINDS)
sizes = st.integers(5_000, 90_000).map(lambda thousandths: thousandths / 1000)
percents = st.integers(0, 100_000).map(lambda thousandths: thousandths / 1000)
zones = st.one_of(
    st.builds(
        Zone,
        kinds_of_zones,
        places,
        places,
        lengths,
        st.just(0.0),
        st.just(0.0),
        percents,
        st.one_of(st.just(0.0), lengths),
    ),
    st.builds(Zone, kinds_of_zones, places, places, st.just(0.0), lengths, lengths, percents, lengths),
)

worlds = st.builds(
    World,
    name=names,
    width_mm=lengths,
    height_mm=lengths,
    walls=st.lists(st.builds(Wall, places, places, places, places), max_size=3).map(tuple),
    floors=st.lists(st.builds(Floor, colours, lines), max_size=2).map(tuple),
    lines=st.lists(st.builds(ColouredLine, colours, lengths, lines, st.booleans()), max_size=2).map(tuple),
    roads=_distinct(_roads()),
    storehouses=_distinct(st.builds(Storehouse, names, places, places, lengths, lengths, counts, counts)),
    docks=_distinct(
        st.builds(
            Dock, names, names, lengths, lengths, names, st.sampled_from([LOAD, UNLOAD]), st.sampled_from([LEFT, RIGHT])
        )
    ),
    starts=_distinct(starts),
    boxes=st.lists(
        st.builds(
            Box,
            places,
            places,
            sizes,
            sizes,
            lengths,
            st.integers(0, 9_000).map(lambda thousandths: thousandths / 1000),
        ),
        max_size=2,
    ).map(tuple),
    balls=st.lists(st.builds(Ball, places, places, sizes, lengths, st.just(0.02)), max_size=2).map(tuple),
    zones=st.lists(zones, max_size=2).map(tuple),
    label=st.dictionaries(st.sampled_from(TEXT_LANGUAGES), labels, max_size=2),
)
"""Worlds whose parts may lie outside, cross, or name what is not there."""
