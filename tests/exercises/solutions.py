"""For each exercise that comes along: programs that reach every goal, and programs that do not, with the goals missed.

Goals are counted from 1, as the tables of `kitrobot grade` do.
"""

from __future__ import annotations

Programs = dict[str, str]

CARRIER = """*[Run.IsTrue()](
  //(
    <Sign.EqualTo(Dock.Value()) | Run.IsFalse()>();,
    °Wheel.Advance(50)°;
    *[Run.IsTrue()](
      <Collision.IsPressed()>(
        Wheel.Stop();
        <Collision.IsReleased()>( Wheel.Advance(50); );
      );
    );
  );
  *[Sign.EqualTo(Dock.Value()) & Run.IsTrue()](
    [Cargo.IsPressed()]( Lamp.LightOn(); Dock.Set(3); )!( Lamp.LightOff(); Dock.Set(0); );
  );
);
"""
LINE = """*[!(LeftEye.IsGreen() | RightEye.IsGreen())](
  [LeftEye.IsBlue()]( LeftWheel.Forward(10); RightWheel.Forward(60); )!(
    [RightEye.IsBlue()]( LeftWheel.Forward(60); RightWheel.Forward(10); )!(
      LeftWheel.Forward(60); RightWheel.Forward(60);
    );
  );
);
LeftWheel.Stop();
RightWheel.Stop();
"""
TO_THE_FIELD = "Wheel.DriveBy(80);"
BY_THE_CLOCK = "Wheel.Advance(50); WAIT(40); Wheel.Stop();"

SOLVED: dict[str, Programs] = {
    "01-first-drive": {"first-drive": TO_THE_FIELD},
    "02-round-the-corner": {"round-the-corner": f"{TO_THE_FIELD} Motor.LeftBy(90); Wheel.DriveBy(60);"},
    "03-square": {"a-square": "4*( Wheel.DriveBy(30); Motor.LeftBy(90); );"},
    "04-five-corners": {"five-corners": "5*( Wheel.DriveBy(30); Motor.LeftBy(72); );"},
    "05-before-the-wall": {"before-the-wall": "Wheel.Advance(50); <Captor.LessThan(20)>(); Wheel.Stop();"},
    "06-blink-and-drive": {
        "blink-and-drive-there": f"//( {TO_THE_FIELD}, 3*( Light.LightOn(); WAIT(5); Light.LightOff(); WAIT(5); ); );"
    },
    "07-red-line": {
        "red-line-green-line": "Wheel.Advance(50); <Light.IsRed()>(); Wheel.Stop(); WAIT(20);"
        " Wheel.Advance(50); <Light.IsGreen()>(); Wheel.Stop();"
    },
    "08-follow-the-line": {"follow-the-line": LINE},
    "09-do-not-bump": {
        "do-not-bump": "5*( //( <Captor.LessThan(30)>();, °Wheel.Advance(60)°; ); Motor.AbsoluteTurn(30, 50); );"
    },
    "10-crossing": {
        "crossing-east": "Wheel.Advance(50); WAIT(70); Wheel.Stop();",
        "crossing-north": "WAIT(60); Wheel.Advance(50); WAIT(70); Wheel.Stop();",
    },
    "11-in-step": {"drive-in-step": "SeqOfPar convoy ( Wheel.Advance(50); WAIT(53); Wheel.Stop(); );"},
    "12-no-jam": {"ring-carrier": CARRIER},
}

KEEPS_DRIVING: dict[str, Programs] = {
    "01-first-drive": {"first-drive": BY_THE_CLOCK},
    "02-round-the-corner": {
        "round-the-corner": f"{BY_THE_CLOCK} Motor.AbsoluteTurn(25, 50); Wheel.Advance(50); WAIT(30); Wheel.Stop();"
    },
    "03-square": {"a-square": "4*( Wheel.Advance(50); WAIT(15); Wheel.Stop(); Motor.AbsoluteTurn(25, 50); );"},
    "04-five-corners": {
        "five-corners": "5*( Wheel.Advance(50); WAIT(15); Wheel.Stop(); Motor.AbsoluteTurn(20, 50); );"
    },
}
"""Other right ways: what keeps driving is stopped by the clock, and turns by hundredths of a full turn."""

WRONG: dict[str, tuple[Programs, list[int]]] = {
    "01-first-drive": ({"first-drive": "Wheel.DriveBy(30);"}, [2]),
    "02-round-the-corner": ({"round-the-corner": TO_THE_FIELD}, [3]),
    "03-square": (
        {"a-square": "3*( Wheel.DriveBy(30); Motor.LeftBy(90); );"},
        [2],
    ),
    "04-five-corners": ({"five-corners": "5*( Wheel.DriveBy(30); Motor.LeftBy(90); );"}, [1]),
    "05-before-the-wall": ({"before-the-wall": "Wheel.Advance(50); WAIT(80); Wheel.Stop();"}, [2, 4, 5]),
    "06-blink-and-drive": (
        {"blink-and-drive-there": f"3*( Light.LightOn(); WAIT(5); Light.LightOff(); WAIT(5); ); {TO_THE_FIELD}"},
        [3],
    ),
    "07-red-line": ({"red-line-green-line": "Wheel.Advance(50); <Light.IsRed()>(); Wheel.Stop();"}, [2, 5]),
    "08-follow-the-line": (
        {"follow-the-line": LINE.replace("LeftWheel.Forward(10)", "LeftWheel.Forward(60)")},
        [1, 2, 3, 4, 5, 7, 8],
    ),
    "09-do-not-bump": (
        {"do-not-bump": "5*( //( <Captor.LessThan(6)>();, °Wheel.Advance(100)°; ); Motor.AbsoluteTurn(30, 50); );"},
        [2],
    ),
    "10-crossing": (
        {
            "crossing-east": "Wheel.Advance(50); WAIT(70); Wheel.Stop();",
            "crossing-north": "Wheel.Advance(50); WAIT(70); Wheel.Stop();",
        },
        [2, 3, 4],
    ),
    "11-in-step": ({"drive-in-step": "SeqOfPar leader ( Wheel.Advance(50); WAIT(53); Wheel.Stop(); );"}, [3, 4]),
    "12-no-jam": ({}, [2, 4, 5]),
}
