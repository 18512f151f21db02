"""Missions to XML, in one true layout, and safely to disk.

`save` replaces a file whole and keeps the old one with a `~` behind its name. Left to others: that nobody else saves
the same file meanwhile.
"""

from __future__ import annotations

from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import replace_whole
from kitrobot.graph.graph_xml import write_program
from kitrobot.mission.breakdown import write_breakdown
from kitrobot.mission.declarations import write_declarations
from kitrobot.mission.model import Mission, Team
from kitrobot.mission.property_forms import write_property
from kitrobot.mission.radio import write_radio
from kitrobot.mission.trial import write_breakpoint, write_failure
from kitrobot.primitives.own_xml import write_constructor, write_variable
from kitrobot.primitives.robot import Texts
from kitrobot.text.sentences import Sentence, Word
from kitrobot.world.xml_writer import world_lines
from kitrobot.xml.foreign import fragment, head, remark
from kitrobot.xml.writer import attributes, text_element


def write_mission(mission: Mission) -> bytes:
    """The `.krt` file: one vertex, arc or agent a line. The same mission gives the same bytes."""
    vertices = (vertex for program in mission.programs for vertex in program.vertices)
    raws = [*mission.unknown, *(vertex.unknown for vertex in vertices if vertex.unknown)]
    foreign, remarks = head(mission.attributes, raws)
    lines = [*map(remark, mission.prolog), f"<kitrobot{attributes(('version', mission.version))}{foreign}>"]
    lines += [*_texts("label", mission.label), *_texts("help", mission.help)]
    for constructor in mission.constructors:
        lines += write_constructor(constructor)
    for variable in mission.variables:
        lines += write_variable(variable)
    for program in mission.programs:
        lines += write_program(program)
    lines += _team(mission.team)
    lines += [f"  {write_breakpoint(breakpoint)}" for breakpoint in mission.breakpoints]
    lines += [f"  {write_failure(failure)}" for failure in mission.failures]
    if mission.radio is not None:
        lines.append(f"  {write_radio(mission.radio)}")
    lines += [f"  {line}" for line in write_breakdown(mission.breakdown)]
    lines += [f"  {write_property(one)}" for one in mission.properties]
    if mission.own_world is not None:
        lines += [f"  {line}" for line in world_lines(mission.own_world)]
    elif mission.world_href:
        lines.append(f"  <world{attributes(('href', mission.world_href))}/>")
    lines += [f"  {fragment(raw)}" for raw in mission.unknown]
    lines += [f"  {raw}" for raw in remarks]
    lines.append("</kitrobot>")
    return ("\n".join(lines) + "\n").encode()


def _texts(name: str, texts: Texts) -> list[str]:
    """One line a language, English first."""
    return [f"  {text_element(name, language, texts[language])}" for language in sorted(texts)]


def _team(team: Team) -> list[str]:
    if team == Team():
        return []
    lines = ["  <team>"]
    for agent in team.agents:
        where = (("start", agent.start or None), ("robot", agent.robot or None))
        lines.append(f"    <agent{attributes(('name', agent.name), ('program', agent.program), *where)}/>")
    for goal in team.goals:
        lines.append(f"    <goal{attributes(('storehouse', goal.storehouse), ('stock', goal.stock))}/>")
    lines += [f"    {line}" for line in write_declarations((team.roles, team.groups, team.works))]
    return [*lines, "  </team>"]


class SaveError(KitRobotError):
    """A mission could not be saved; what was there before is still there."""


def save(path: Path, mission: Mission, data: bytes | None = None, *, over_input: bool = False) -> bytes:
    """Writes a mission to `path`, keeps what was there as `path~`, and gives the bytes written.

    Args:
        path: the file.
        mission: what is written.
        data: a file of that mission as somebody wrote it, which counts then.
        over_input: whether it may be a file that this command has read.

    Raises:
        SaveError: the operating system refused; the old file is untouched.
        OutputPlaceError: it is a file that this command has read.
    """
    data = write_mission(mission) if data is None else data
    try:
        replace_whole(path, data, keep_old=True, over_input=over_input)
    except FileNotFoundError as error:
        raise SaveError(
            Sentence("`{path}` cannot be saved: there is no folder `{folder}`", path.name, path.parent.name),
            Sentence("make the folder first"),
        ) from error
    except OSError as error:
        raise SaveError(
            Sentence("`{path}` cannot be saved: {reason}", path.name, Word(error.strerror or error)),
            Sentence("The file is as it was."),
        ) from error
    return data
