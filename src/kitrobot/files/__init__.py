"""Files of every kind on disk: found, read, written whole, locked, recovered; missions inside pictures.

The door opens lazily, because whoever lays out a text needs no journals.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from kitrobot.lazy import lazy_names

if TYPE_CHECKING:
    from kitrobot.files.disk import (
        LARGEST_FILE_BYTES,
        LOCK_NAME,
        UNREADABLE,
        FileError,
        decode,
        expect_unchanged,
        make_folder,
        read_bytes,
        read_text,
        replace_file,
        replace_whole,
        same_file,
        saving_in,
        suggest_similar_name,
        sweep,
        write_atomic,
    )
    from kitrobot.files.embedded_mission import CarriedError, carried_mission, is_picture, read_carried
    from kitrobot.files.examples import examples_folder, find_mission, first_example
    from kitrobot.files.file_lock import FileLock
    from kitrobot.files.folder import (
        EXAMPLE,
        EXERCISE_ENDING,
        HANDED_OUT,
        RECORDING,
        RENAME,
        TUTORIAL_ENDING,
        ConflictError,
        MissionFolder,
        MissionNameError,
        ReadOnlyError,
        revision_of,
    )
    from kitrobot.files.forms import Form, FormError, form_of
    from kitrobot.files.journal_file import Journal, JournalError, read_journal, write_journal
    from kitrobot.files.layout import Layout, lay_out, lay_out_file
    from kitrobot.files.listing import NAME_NO_TEXT, MissionEntry, name_as_text, utc_moment
    from kitrobot.files.places import Places
    from kitrobot.files.quota import Quota, QuotaError, measured, writing_within
    from kitrobot.files.recovery import Claimed, Journals, OrphanedJournal, TabStatus
else:
    # Hidden from mypy, which would take every name for one that there is.
    __getattr__ = lazy_names(
        __name__,
        {
            "disk": (
                "LARGEST_FILE_BYTES",
                "LOCK_NAME",
                "UNREADABLE",
                "FileError",
                "decode",
                "expect_unchanged",
                "suggest_similar_name",
                "make_folder",
                "read_bytes",
                "read_text",
                "replace_file",
                "replace_whole",
                "same_file",
                "saving_in",
                "sweep",
                "write_atomic",
            ),
            "embedded_mission": ("CarriedError", "carried_mission", "is_picture", "read_carried"),
            "examples": ("examples_folder", "find_mission", "first_example"),
            "file_lock": ("FileLock",),
            "folder": (
                "EXAMPLE",
                "HANDED_OUT",
                "RECORDING",
                "RENAME",
                "EXERCISE_ENDING",
                "TUTORIAL_ENDING",
                "ConflictError",
                "MissionFolder",
                "MissionNameError",
                "ReadOnlyError",
                "revision_of",
            ),
            "forms": ("Form", "FormError", "form_of"),
            "journal_file": ("Journal", "JournalError", "read_journal", "write_journal"),
            "layout": ("Layout", "lay_out", "lay_out_file"),
            "listing": ("NAME_NO_TEXT", "MissionEntry", "name_as_text", "utc_moment"),
            "places": ("Places",),
            "quota": ("Quota", "QuotaError", "measured", "writing_within"),
            "recovery": ("Claimed", "Journals", "OrphanedJournal", "TabStatus"),
        },
    )

__all__ = [
    "EXAMPLE",
    "EXERCISE_ENDING",
    "HANDED_OUT",
    "LARGEST_FILE_BYTES",
    "LOCK_NAME",
    "NAME_NO_TEXT",
    "RECORDING",
    "RENAME",
    "TUTORIAL_ENDING",
    "UNREADABLE",
    "CarriedError",
    "Claimed",
    "ConflictError",
    "FileError",
    "FileLock",
    "Form",
    "FormError",
    "Journal",
    "JournalError",
    "Journals",
    "Layout",
    "MissionEntry",
    "MissionFolder",
    "MissionNameError",
    "OrphanedJournal",
    "Places",
    "Quota",
    "QuotaError",
    "ReadOnlyError",
    "TabStatus",
    "carried_mission",
    "decode",
    "examples_folder",
    "expect_unchanged",
    "find_mission",
    "first_example",
    "form_of",
    "is_picture",
    "lay_out",
    "lay_out_file",
    "make_folder",
    "measured",
    "name_as_text",
    "read_bytes",
    "read_carried",
    "read_journal",
    "read_text",
    "replace_file",
    "replace_whole",
    "revision_of",
    "same_file",
    "saving_in",
    "suggest_similar_name",
    "sweep",
    "utc_moment",
    "write_atomic",
    "write_journal",
    "writing_within",
]
