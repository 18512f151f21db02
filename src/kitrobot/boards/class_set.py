"""Many boards on one machine, each with the program that a list names for the label on it.

The list is a table (CSV) with the columns `label` and `mission`, and optionally `program`, `kit` and `port`; or a
folder of missions, each for the board whose label is the file's name. Mistakes in the list are reported before anything
is sent; a fault of one board, or of one mission, does not stop the others.
"""

from __future__ import annotations

import csv
import io
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from kitrobot.boards.labels import LabelError, clean_label, label_key, labels_of
from kitrobot.boards.programs import load_board_program
from kitrobot.boards.sent_firmware import store_firmware_version
from kitrobot.boards.sent_programs import store_sent_program
from kitrobot.deploy.firmware.ports import list_ports
from kitrobot.diagnostics.model import KitRobotError, Place
from kitrobot.files.disk import read_text
from kitrobot.robots import board_operations
from kitrobot.robots.board_operations import Progress, SendResult
from kitrobot.robots.program import BoardProgram
from kitrobot.text.forms import name_form
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.text.suggestions import did_you_mean

COLUMNS = ("label", "mission", "program", "kit", "port")
MOST_BOARDS = 200
_ENDING = ".krt"


@dataclass(eq=False)
class SetError(KitRobotError):
    """The list cannot be used; `place`: the line."""

    place: Place | None = None


class NoLabelError(KitRobotError):
    """No board that is plugged in has the label, or several have it."""


@dataclass(frozen=True)
class BoardOrder:
    """What a board is to get; "" where the list says nothing."""

    label: str
    mission: Path
    program: str = ""
    kit: str = ""
    port: str = ""


@dataclass(frozen=True)
class Member:
    """A board of the set: where it is ("" if nowhere), and its program or the error that keeps it from it."""

    wanted: BoardOrder
    address: str
    program: BoardProgram | None
    error: KitRobotError | None


@dataclass(frozen=True)
class SetResult:
    """What became of a board of the set."""

    member: Member
    sent: SendResult | None

    @property
    def error(self) -> KitRobotError | None:
        """Why it does not run its program; None: it does."""
        return self.member.error if self.sent is None else self.sent.error


@dataclass(frozen=True)
class BoardSet:
    """The boards of a list in its order, before anything is sent; `others`: addresses of boards that are not in it."""

    members: tuple[Member, ...]
    others: tuple[str, ...]

    @property
    def addresses(self) -> list[str]:
        """Of the boards that something is sent to."""
        return [one.address for one in self.members if one.program is not None]

    def send(self, progress: Progress, *, replace: bool = False, fresh: bool = False) -> list[SetResult]:
        """Sends all programs at once; what goes wrong with one board does not hold up the others."""
        programs = {one.address: one.program for one in self.members if one.program is not None}
        sent = {
            one.address: one for one in board_operations.send_programs(programs, progress, replace=replace, fresh=fresh)
        }
        for address, one in sent.items():
            if one.deployed is not None:
                store_sent_program(programs[address], [one.deployed.program])
                store_firmware_version(address, one.deployed)
        return [SetResult(one, sent[one.address] if one.program is not None else None) for one in self.members]


def read_set(path: Path) -> list[BoardOrder]:
    """What a list says: a table, or a folder of missions.

    Raises:
        SetError: it is none, it says nothing, or a label or a port stands in it twice.
        FileError: it cannot be read.
    """
    if path.is_dir():
        found = [
            BoardOrder(_label(one.stem, None), one) for one in sorted(path.iterdir()) if one.suffix.lower() == _ENDING
        ]
        if not found:
            raise SetError(
                Sentence("there is no mission in the folder `{folder}`", path),
                Sentence("put a `.krt` for each board into it, with the board's label as its name"),
            )
        places: Sequence[Place | None] = [None] * len(found)
    else:
        found, places = _table(path)
    if len(found) > MOST_BOARDS:
        raise SetError(Sentence("a set has at most {most} boards, and this one has {count}", MOST_BOARDS, len(found)))
    _expect_once(found, places)
    return found


def prepare_set(wanted: Sequence[BoardOrder]) -> BoardSet:
    """Finds the board of each label and makes its program ready; nothing is sent yet."""
    there = [port.address for port in list_ports()]
    places: dict[str, list[str]] = defaultdict(list)
    for address, label in labels_of(there).items():
        places[label_key(label)].append(address)
    ready: dict[tuple[Path, str, str], BoardProgram | KitRobotError] = {}
    members = []
    taken: dict[str, str] = {}
    for one in wanted:
        address, error = _address(one, places)
        if error is None and address in taken:
            error = NoLabelError(
                Sentence(
                    "`{agent}` and `{other}` are both given the board on `{port}`", taken[address], one.label, address
                )
            )
        if error is None:
            taken[address] = one.label
        made = _program(one, ready)
        if error is None and isinstance(made, KitRobotError):
            error = made
        program = made if error is None and isinstance(made, BoardProgram) else None
        members.append(Member(one, address, program, error))
    return BoardSet(tuple(members), tuple(address for address in there if address not in taken))


def _program(
    one: BoardOrder, ready: dict[tuple[Path, str, str], BoardProgram | KitRobotError]
) -> BoardProgram | KitRobotError:
    """Its program, made once for all boards that get the same; or why there is none."""
    key = (one.mission, one.program, one.kit)
    if key not in ready:
        try:
            ready[key] = load_board_program(one.mission, program=one.program or None, kit=one.kit or None)
        except KitRobotError as error:
            ready[key] = error
    return ready[key]


def _address(one: BoardOrder, places: Mapping[str, Sequence[str]]) -> tuple[str, KitRobotError | None]:
    """Where the board is, or why nobody knows."""
    if one.port:
        return one.port, None
    found = places.get(label_key(one.label), ())
    if len(found) == 1:
        return found[0], None
    if found:
        return "", NoLabelError(
            Sentence("several boards have the label `{label}`: {ports}", one.label, Series(COMMA, found)),
            Sentence("write the port of each into the list, in the column `port`"),
        )
    return "", NoLabelError(
        Sentence("no board with the label `{label}` is plugged in", one.label),
        Sentence("plug it in, or give a board that label with {command}", "`kitrobot boards --to PORT --label NAME`"),
    )


def _table(path: Path) -> tuple[list[BoardOrder], list[Place | None]]:
    """The rows of a table, with their places; cells may be parted by commas or semicolons."""
    text = read_text(path)
    first = text.partition("\n")[0]
    parted = ";" if first.count(";") > first.count(",") else ","
    try:
        rows = list(_rows(text, parted))
    except csv.Error as error:
        raise SetError(Sentence("`{file}` is no table: {reason}", path, str(error)), _example()) from None
    header, place = ([cell.strip().lower() for cell in rows[0][1]], rows[0][0]) if rows else ([], 1)
    for name in header:
        if name not in COLUMNS:
            help = did_you_mean(name, COLUMNS) or Sentence("its columns: {names}", listed(COLUMNS))
            raise SetError(
                Sentence("a list of boards has no column `{name}`", name[:80]), help, place=Place(str(path), place)
            )
    if not {"label", "mission"} <= set(header) or len(set(header)) != len(header):
        raise SetError(
            Sentence("the first line of a list of boards names its columns, each once: at least `label` and `mission`"),
            _example(),
            place=Place(str(path), place),
        )
    if len(rows) == 1:
        raise SetError(Sentence("`{file}` names no board", path), _example())
    found: list[BoardOrder] = []
    places: list[Place | None] = []
    for line, cells in rows[1:]:
        at = Place(str(path), line)
        if len(cells) > len(header):
            raise SetError(Sentence("this line has more cells than the first one"), _example(), place=at)
        said = dict(zip(header, (cell.strip() for cell in cells), strict=False))
        if not said.get("mission"):
            raise SetError(Sentence("this line names no mission"), _example(), place=at)
        mission = path.parent / said["mission"]
        label = _label(said.get("label", ""), at)
        found.append(
            BoardOrder(label, mission, *(name_form(said.get(name, "")) for name in ("program", "kit", "port")))
        )
        places.append(at)
    return found, places


def _rows(text: str, parted: str) -> Iterable[tuple[int, list[str]]]:
    """The lines that say something, by number."""
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=parted, strict=True)
    for cells in reader:
        if any(cell.strip() for cell in cells):
            yield reader.line_num, cells


def _label(given: str, place: Place | None) -> str:
    try:
        return clean_label(given)
    except LabelError as error:
        raise SetError(Sentence("`{label}` is no name for a label", given[:80]), error.help, place=place) from None


def _example() -> Sentence:
    return Sentence("write it as {first} and then lines such as {second}", "`label,mission`", "`A1,heart.krt`")


def _expect_once(found: Sequence[BoardOrder], places: Sequence[Place | None]) -> None:
    labels: set[str] = set()
    ports: set[str] = set()
    for one, place in zip(found, places, strict=True):
        if label_key(one.label) in labels:
            raise SetError(Sentence("the label `{label}` stands in the list twice", one.label), "", place=place)
        if one.port and one.port in ports:
            raise SetError(Sentence("the port `{port}` stands in the list twice", one.port), "", place=place)
        labels.add(label_key(one.label))
        ports.add(one.port)
