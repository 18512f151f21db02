"""`kitrobot class [FOLDER]`: a class whose pupils join from their browsers."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Protocol

import typer

from kitrobot.cli.options import ListenPort
from kitrobot.cli.output import print_data, print_message
from kitrobot.cli.studio import StudioError
from kitrobot.text.phrases import one_of
from kitrobot.text.sentences import Sentence


@dataclass(frozen=True)
class ClassOptions:
    """The options of `kitrobot class`; `tls` is a certificate and its key, `https` asks for one of its own, and with
    neither it is plain HTTP; `site` is the folder of a static site, None for that in the folder of the class.
    """

    folder: Path
    host: str
    port: int | None
    tls: tuple[Path, Path] | None
    https: bool
    browser: bool
    new_code: bool
    site: Path | None


class Classroom(Protocol):
    """Opens a class and returns when it is closed."""

    def __call__(self, options: ClassOptions, /) -> None: ...


def open_class(
    context: typer.Context,
    folder: Annotated[
        Path, typer.Argument(metavar="FOLDER", help="The folder of the class; made where there is none.")
    ] = Path("Class"),
    host: Annotated[
        str, typer.Option(help="The address of this machine to listen on; pupils at other machines need it.")
    ] = "127.0.0.1",
    port: ListenPort = None,
    https: Annotated[
        bool, typer.Option("--https", help="Encrypt, with a certificate that KitRobot makes; browsers warn once.")
    ] = False,
    tls: Annotated[
        tuple[Path, Path] | None,
        typer.Option(metavar="CERT KEY", help="Encrypt, with this certificate and its key (PEM).", show_default=False),
    ] = None,
    browser: Annotated[bool, typer.Option(help="Open the teacher's page in the browser.")] = True,
    site: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help="A folder that `kitrobot site` wrote: programs run in the pupils' own browsers then.",
            show_default="Site in the folder of the class",
        ),
    ] = None,
    new_code: Annotated[bool, typer.Option("--new-code", help="Another code than the one it had.")] = False,
    marks: Annotated[
        str | None,
        typer.Option(
            metavar="moodle|canvas|sheet",
            help="Write the marks into the folder for that gradebook, or as a plain sheet, and open no class.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Open a class: pupils join with a code, the teacher sees what each one does. Ctrl-C ends it.

    The first line of the output is the address of the teacher's page; with `--marks` it is the file. What pupils make
    is in the folder, a folder for each of them.
    """
    if folder.exists() and not folder.is_dir():
        raise StudioError(Sentence("`{path}` is no folder", folder), Sentence("name a folder for the class"))
    if marks is not None:
        _write_marks(folder, marks)
        return
    if https and tls is not None:
        raise StudioError(
            Sentence("`{one}` and `{other}` name two certificates", "--https", "--tls"),
            Sentence("leave out `--https`: `--tls` opens the class over https too"),
        )
    classroom: Classroom | None = context.obj
    if classroom is None:
        raise StudioError(
            Sentence("this command line was started without a studio"), Sentence("start it with `python -m kitrobot`")
        )
    classroom(ClassOptions(folder, host, port, tls, https, browser, new_code, site))


def _write_marks(folder: Path, gradebook: str) -> None:
    """Writes the marks of the class as CSV into its folder, and prints where; a class that is open stays as it is."""
    from kitrobot.classroom.gradebook_list import NAME, read_gradebook_list
    from kitrobot.classroom.gradebook_tables import GRADEBOOKS, marks_as_csv
    from kitrobot.classroom.record import read_record
    from kitrobot.files.disk import write_atomic

    known = next((one for one in GRADEBOOKS if one == gradebook), None)
    if known is None:
        raise StudioError(
            Sentence("`{name}` is no gradebook", gradebook), Sentence("it is {names}", one_of([*GRADEBOOKS]))
        )
    record = read_record(folder)
    if record is None:
        raise StudioError(
            Sentence("there is no class in `{path}`", folder), Sentence("name the folder that has its `class.toml`")
        )
    made = marks_as_csv(known, record.pupils, read_gradebook_list(folder))
    path = folder / f"marks-{known}.csv"
    write_atomic(path, made.data)
    print_data(f"{path}\n")
    if not made.exercises:
        print_message(Sentence("nothing is graded yet: press Grade on the teacher's page first"))
    for name in made.unlisted:
        print_message(Sentence("`{name}` is not in `{file}`, or more than once: look at this line", name, NAME))
