"""A class: pupils with a folder each, what they hand in, and what their teacher does with all of them; without HTTP."""

from kitrobot.classroom.admission import Admission, AdmissionRefusedError, NameTakenError
from kitrobot.classroom.class_room import GRADES_PAGE, GRADES_TABLE, SITE, STUDIOS, ClassError, ClassRoom
from kitrobot.classroom.names import InvalidNameError
from kitrobot.classroom.pupil import Goal, Pupil, Report, State, met, state_of
from kitrobot.classroom.pupil_status import Handed, HandIn, PupilStatus, Turn
from kitrobot.classroom.rate_limits import GuessLimit, RateLimit
from kitrobot.classroom.record import ClassRecord, PupilRecord, UnreadPupil, read_record, unread_sentence, write_record
from kitrobot.classroom.submissions import Submission
from kitrobot.classroom.teacher_actions import TeacherActions

__all__ = [
    "GRADES_PAGE",
    "GRADES_TABLE",
    "SITE",
    "STUDIOS",
    "Admission",
    "AdmissionRefusedError",
    "ClassError",
    "ClassRecord",
    "ClassRoom",
    "Goal",
    "GuessLimit",
    "HandIn",
    "Handed",
    "InvalidNameError",
    "NameTakenError",
    "Pupil",
    "PupilRecord",
    "PupilStatus",
    "RateLimit",
    "Report",
    "State",
    "Submission",
    "TeacherActions",
    "Turn",
    "UnreadPupil",
    "met",
    "read_record",
    "state_of",
    "unread_sentence",
    "write_record",
]
