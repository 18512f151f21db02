"""The rules of graphs: what can be wrong with vertices and arcs before there is any LLL."""

from kitrobot.diagnostics.model import Severity, rule

UNKNOWN_ELEMENT = rule(
    "unknown-element",
    Severity.ERROR,
    "A vertex is of an element that nothing here defines",
    "Elements come from the constructors' and the robot's XML. The vertex is kept word for word until its XML is back.",
)
START_STOP = rule(
    "start-stop",
    Severity.ERROR,
    "The graph does not have exactly one start and one stop",
    "Each program has one vertex Start, where it begins, and one vertex Stop, where it ends.",
)
SAME_ID = rule(
    "same-id",
    Severity.ERROR,
    "Two vertices have the same id",
    "Arcs name vertices by id, so each id is used once in a program.",
)
DANGLING_ARC = rule(
    "dangling-arc",
    Severity.ERROR,
    "An arc begins or ends at something that is not there",
    "An arc goes from a port of a vertex to a port of a vertex of the same program.",
)
TWO_ARCS = rule(
    "two-arcs",
    Severity.ERROR,
    "Two arcs use a port that takes one",
    "Control goes one way from each out-port, and one thing fills each slot.",
)
NOT_CLOSED = rule(
    "slot-not-closed",
    Severity.ERROR,
    "The way through a slot does not come back",
    "What leaves a constructor through a slot comes back at its `return`; an empty slot is an arc from the slot "
    "straight to `return`. The program's own way ends at Stop.",
)
WRONG_WAY = rule(
    "wrong-way",
    Severity.ERROR,
    "An arc leads where control cannot go",
    "An arc cannot lead into the middle of another body, back to a vertex that was passed already, or to the `return` "
    "of a constructor it is not inside of.",
)
EMPTY_SLOT = rule(
    "empty-slot",
    Severity.ERROR,
    "A slot that must be filled is empty",
    "A condition needs a test; a marked action needs its action. Drop one on the slot.",
)
NOT_A_NUMBER = rule(
    "not-a-number",
    Severity.ERROR,
    "What was typed in is not a whole number in range",
    "Numbers in a program are whole, have no sign, and lie between 0 and 65535, or within their slot's own range.",
)
WRONG_PLACE = rule(
    "wrong-place",
    Severity.ERROR,
    "A part stands where it does not fit",
    "Conditions fill condition slots, instructions stand in the flow; a constructor that adds a branch is no vertex.",
)
PARKED = rule(
    "parked",
    Severity.HINT,
    "Nothing leads to a part",
    "Parts that no arc from Start leads to are kept and shown, and not compiled.",
)
TOO_DEEP = rule(
    "graph-too-deep",
    Severity.ERROR,
    "The graph nests too deeply",
    "Bodies, conditions and parameters together may nest 100 levels deep. Split the program into parts.",
)
TWO_HOLES = rule(
    "two-places",
    Severity.ERROR,
    "A part of one's own has two places for instructions in one body",
    "A body of a template has at most one hole for instructions. Instructions in a row can be one place together.",
)
OPEN_BREAK = rule(
    "break-leaves-part",
    Severity.ERROR,
    "A Break in a part of one's own leaves a loop outside it",
    "A part can stand anywhere. A Break in it that leaves the loop around it would leave another loop there, or end "
    "the program.",
)
NOT_A_SET = rule(
    "not-a-set",
    Severity.ERROR,
    "A slot for a set of robots holds none",
    "A set is the name of a role, a group or an agent, or several of them: `{carriers, loader}`. A name that is not "
    "made of letters and digits, joined by single hyphens, stands between double quotes.",
)
WRONG_LEVEL = rule(
    "wrong-level",
    Severity.ERROR,
    "A vertex stands in a program of another level",
    "Constructors of the levels group and social speak of several robots, so they stand in a team's program; those of "
    "the level social stand in a social program only.",
)
