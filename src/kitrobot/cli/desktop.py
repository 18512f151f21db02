"""`kitrobot desktop`: an entry in the menu of the desktop."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from kitrobot.cli.output import print_message


def desktop_entry(
    folder: Annotated[
        Path | None,
        typer.Argument(metavar="[FOLDER]", help="The folder of missions that it opens.", show_default="~/KitRobot"),
    ] = None,
    install: Annotated[bool, typer.Option("--install", help="Put KitRobot into the menu.")] = False,
    remove: Annotated[bool, typer.Option("--remove", help="Take it away again; missions stay.")] = False,
) -> None:
    """Put KitRobot into the menu of a Linux desktop, for this user, and have it open `.krt` files."""
    if install == remove:
        raise typer.BadParameter("say one of --install and --remove", param_hint="'--install'")
    if remove and folder is not None:
        raise typer.BadParameter("a folder belongs to --install", param_hint="'FOLDER'")
    from kitrobot.packaging.desktop_entry import install_entry, remove_entry

    if remove:
        removed = remove_entry()
        for path in removed:
            print_message(f"{path}: removed")
        if not removed:
            print_message("there is no entry")
        return
    missions = folder if folder is not None else Path.home() / "KitRobot"
    for path in install_entry(missions).all:
        print_message(f"{path}: written")
    print_message(f"KitRobot is in the menu, and opens {missions.absolute()}")
