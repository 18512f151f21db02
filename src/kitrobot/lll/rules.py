"""The rules of syntax: what can be wrong with a text before anybody asks what its names mean."""

from kitrobot.diagnostics.model import Severity, rule

SYNTAX = rule(
    "syntax",
    Severity.ERROR,
    "The text is not LLL",
    "Something stands where the grammar allows something else. The reader goes on after the next `;`, `,` or `)`, so "
    "that one mistake does not hide the others.",
)
NOT_CLOSED = rule(
    "not-closed",
    Severity.ERROR,
    "A bracket is never closed",
    "Every `(`, `[` and `<` needs its partner, and a marked action needs its second `°`.",
)
NUMBER_TOO_LARGE = rule(
    "number-too-large",
    Severity.ERROR,
    "A number is larger than the language can write",
    "Numbers are whole and lie between 0 and 65535.",
)
RESERVED_WORD = rule(
    "reserved-word",
    Severity.ERROR,
    "A word of the language stands where a name belongs",
    "`WAIT` and `BREAK` are words of the language, so no robot object and no method can have them as a name.",
)
CONDITIONAL_AS_CONDITION = rule(
    "conditional-as-condition",
    Severity.ERROR,
    "A whole conditional stands inside a condition",
    "A condition is a test, or tests joined with `&`, `|` and `!( )`. `[test](…)` is an instruction that acts on a "
    "condition; it is not one itself.",
)
TOO_DEEP = rule(
    "too-deep",
    Severity.ERROR,
    "The program nests too deeply",
    "Bodies, conditions and parameters together may nest 100 levels deep. Split the program into parts.",
)
MISSING_SEMICOLON = rule(
    "missing-semicolon",
    Severity.HINT,
    "A `;` is missing between two instructions",
    "The reader understood the program without it; `kitrobot format` writes every `;`.",
)
HOLE_IN_PROGRAM = rule(
    "hole-in-program",
    Severity.ERROR,
    "A hole stands in a program",
    "`{name}` is a hole of a constructor's template; a program has none.",
)
TEAM_FORM = rule(
    "team-form",
    Severity.ERROR,
    "A form of a team's program stands in the program of one robot",
    "Roles, groups, work, `SeqOfPar`, `ParOfSeq`, `Where`, `PROGRAM`, `MOVE` and tests with `any`, `all` or `most` "
    "speak of several robots. They stand in programs of the level group or social.",
)
