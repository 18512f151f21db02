"""A class: pupils with a folder each, what they hand in, and what their teacher does with all of them; without HTTP."""

from kitrobot.classroom.allowance import Allowance, Guesses
from kitrobot.classroom.desk import Desk
from kitrobot.classroom.entrance import Entrance, NotLetInError, TakenNameError
from kitrobot.classroom.names import WrongNameError
from kitrobot.classroom.pupil import Goal, Pupil, Report, State, met, state_of
from kitrobot.classroom.record import ClassRecord, PupilRecord, UnreadPupil, read_record, unread_sentence, write_record
from kitrobot.classroom.room import GRADES_PAGE, GRADES_TABLE, SITE, STUDIOS, ClassError, ClassRoom
from kitrobot.classroom.told import Handed, HandIn, Told, Turn
from kitrobot.classroom.work import Work

__all__ = [
    "GRADES_PAGE",
    "GRADES_TABLE",
    "SITE",
    "STUDIOS",
    "Allowance",
    "ClassError",
    "ClassRecord",
    "ClassRoom",
    "Desk",
    "Entrance",
    "Goal",
    "Guesses",
    "HandIn",
    "Handed",
    "NotLetInError",
    "Pupil",
    "PupilRecord",
    "Report",
    "State",
    "TakenNameError",
    "Told",
    "Turn",
    "UnreadPupil",
    "Work",
    "WrongNameError",
    "met",
    "read_record",
    "state_of",
    "unread_sentence",
    "write_record",
]
