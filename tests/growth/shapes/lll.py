"""LLL texts."""

from __future__ import annotations

from tests.growth.shapes.registry import lines, shape

lines(
    "lll",
    {
        "instructions": ("", "Wheel.Advance(50);\n", ""),
        "instructions on one line": ("", "Wheel.Advance(50); ", ""),
        "unknown objects": ("", "Nothing#.Advance(50);\n", ""),
        "one unknown object": ("", "Whel.Advance(50);\n", ""),
        "unknown methods": ("", "Wheel.Nothing#(50);\n", ""),
        "instructions without semicolons": ("", "Wheel.Stop()\n", ""),
        "wrong numbers of parameters": ("", "Wheel.Stop(1,2,3);\n", ""),
        "parameters of one call": ("Wheel.Advance(", "1,", "1);"),
        "parameters that are calls": ("Wheel.Advance(", "Captor.Value(),", "1);"),
        "semicolons": ("", ";", ""),
        "line feeds": ("", "\n", ""),
        "spaces": ("", " ", ""),
        "carriage returns": ("", "\r", ""),
        "blanks before an instruction": ("", "\n \t", "Wheel.Stop();"),
        "blanks within a call": ("Wheel", " ", ".Stop();"),
        "blanks within parentheses": ("Wheel.Advance(", "\n", "50);"),
        "blanks after a name": ("", "Wheel   \n", ""),
        "names": ("", "Wheel ", ""),
        "blocks of a team": ("", "SeqOfPar {a, b} ( Wheel.Stop(); );\n", ""),
        "blocks that do not end": ("", "SeqOfPar a (", ""),
        "members of a block": ("SeqOfPar {", "a-b, ", "c} ();"),
        "hyphens of a name": ("PROGRAM a", "-a", ";"),
        "questions to a team": ("*[", "any a (", "Run.IsTrue()]();"),
        "declarations": ("", "role r#: x;\n", ""),
        "names with points": ("Wheel", ".Advance", "(50);"),
        "calls that do not end": ("", "Wheel.Advance(", ""),
        "calls with numbers that do not end": ("Wheel.Advance(50", ", 50", ";"),
        "letters of a name": ("Wheel", "a", ".Stop();"),
        "letters in another script": ("Wheel", "م", ".Stop();"),
        "vowel signs": ("م", "\u0652", ".Stop();"),
        "digits": ("Wheel.Advance(", "9", ");"),
        "zeros": ("Wheel.Advance(", "0", "1);"),
        "quotation marks": ("", '"', ""),
        "full stops": ("", ".", ""),
        "slashes": ("", "/", ""),
        "hashes": ("", "#\n", ""),
        "exclamation marks": ("", "!", ""),
        "opening parentheses": ("", "(", ""),
        "closing parentheses": ("", ")", ""),
        "opening brackets": ("", "[", ""),
        "closing brackets": ("", "]", ""),
        "opening angles": ("", "<", ""),
        "opening parallels": ("", "//(", ""),
        "opening whiles": ("", "*[Run.IsTrue()](", ""),
        "marks": ("", "°", ""),
        "holes": ("", "{x};", ""),
        "opening braces": ("", "{", ""),
        "opening braces and names": ("", "{ x ", ""),
        "conditions that do not end": ("", "*[Run.IsTrue(", ""),
        "guards within guards": ("", "[Run.IsTrue() & [", ""),
        "conjunctions": ("*[Run.IsTrue()", " & Run.IsTrue()", "](Wheel.Stop(););"),
        "disjunctions": ("*[Run.IsTrue()", " | Run.IsTrue()", "](Wheel.Stop(););"),
        "alternating conjunctions": ("*[Run.IsTrue()", " | Run.IsTrue() & Run.IsTrue()", "](Wheel.Stop(););"),
        "negations": ("*[", "!(", "Run.IsTrue()](Wheel.Stop(););"),
        "comments": ("", "# a comment\n", "Wheel.Stop();"),
        "comments alone": ("", "# a comment\n", ""),
        "comments behind instructions": ("", "Wheel.Stop(); # stop\n", ""),
        "comments behind whiles": ("", "*[Run.IsTrue()]( Wheel.Stop(); # a\n # b\n ); # c\n", ""),
        "comments within a call": ("Wheel.Advance(", "# a comment\n", "50);"),
        "comments within calls": ("", "Wheel.Advance( # a\n 50 # b\n); # c\n", ""),
        "comments within a condition": ("*[Run.IsTrue()", " & # a\n Run.IsTrue()", "](Wheel.Stop(););"),
        "letters of a comment": ("# ", "a", "\nWheel.Stop();"),
        "branches": ("//(", "Wheel.Stop();,", "Wheel.Stop(););"),
        "empty branches": ("//(", ",", ");"),
        "branches with comments": ("//(", "# a\n,", ");"),
        "parallels": ("", "//(Wheel.Stop();, Wheel.Advance(5););\n", ""),
        "marked actions": ("//(", "°Wheel.Advance(5)°;", ", WAIT(5););"),
        "marked actions outside": ("", "°Wheel.Advance(5)°;", ""),
        "shared actuators": ("//(", "Wheel.Advance(5);,", "Wheel.Stop(););"),
        "conditionals": ("", "[Run.IsTrue()](Wheel.Stop(););\n", ""),
        "conditionals with else": ("", "[Run.IsTrue()](Wheel.Stop();)!(Wheel.Stop(););\n", ""),
        "events": ("", "<Captor.LessThan(20)>();\n", ""),
        "repetitions": ("", "3*(Wheel.Stop(););\n", ""),
        "repetitions of nothing": ("", "0*(Wheel.Stop(););\n", ""),
        "breaks": ("", "BREAK;\n", ""),
        "breaks in a loop": ("*[Run.IsTrue()](", "BREAK;\n", ");"),
        "waits": ("", "WAIT(10);\n", ""),
        "waits for nothing": ("", "WAIT();\n", ""),
        "endless loops": ("", "*[1](Wheel.Stop(););\n", ""),
        "commas": ("3*(", "Wheel.Stop();,", ");"),
        "commas alone": ("", ",", ""),
        "numbers": ("", "5 ", ""),
        "large numbers": ("", "Wheel.Advance(99999);\n", ""),
        "numbers out of range": ("", "Wheel.Advance(999);\n", ""),
        "tests as instructions": ("", "Captor.LessThan(5);\n", ""),
        "instructions as tests": ("", "*[Wheel.Stop()](WAIT(1););\n", ""),
        "values as tests": ("", "*[Captor.Value()](WAIT(1););\n", ""),
        "tests as parameters": ("", "Wheel.Advance(Captor.LessThan(5));\n", ""),
        "mistakes within parentheses": ("3*(", "Wheel.Stop(;\n", ");"),
        "mistakes at the ends of lines": ("", "Wheel.Stop(\n", ""),
        "words of the language as names": ("", "WAIT.BREAK();\n", ""),
        "mistakes": ("", "?? %% Wheel\n", ""),
        "mistakes on one line": ("", "?? ", ""),
        "unclosed whiles after one another": ("", "*[Run.IsTrue(](Wheel.Stop();\n", ""),
        "nul characters": ("", "\0", ""),
        "wide characters": ("", "漢\n", ""),
    },
)


@shape("lll bodies in one another, as deep as may be")
def _deep(n: int) -> str:
    return ("3*(" * 50 + "Wheel.Stop();" + ");" * 50 + "\n") * (n // 50 + 1)


@shape("lll bodies in one another, too deep")
def _too_deep(n: int) -> str:
    return "3*(" * n + "Wheel.Stop();" + ");" * n


@shape("lll conditionals in one another, too deep")
def _too_deep_conditions(n: int) -> str:
    return "*[" + "(" * n + "Run.IsTrue()" + ")" * n + "](Wheel.Stop(););"


@shape("lll calls in one another")
def _calls(n: int) -> str:
    return "Wheel.Advance(" * n + "1" + ")" * n + ";"


@shape("lll parallels in one another")
def _parallels(n: int) -> str:
    return ("//(Wheel.Stop();, " * 40 + "Wheel.Stop();" + ");" * 40 + "\n") * (n // 40 + 1)
