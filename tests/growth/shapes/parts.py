"""Robots, constructors, tutorials and exercises."""

from __future__ import annotations

from tests.growth.shapes.registry import lines

_ROBOT = '<robot name="r" version="1" tick="20" wait-unit="100">\n'
_SENSOR = (
    '<sensor name="S#" device="range"><operation name="LessThan" test="less">'
    '<parameter name="value" min="0" max="9"/></operation></sensor>'
)
lines(
    "robot.xml",
    {
        what: (_ROBOT + before, one + "\n", after + "</robot>\n")
        for what, (before, one, after) in {
            "sensors": ("", '<sensor name="S#" device="range"/>', ""),
            "sensors of one name": ("", '<sensor name="S" device="range"/>', ""),
            "sensors with tests": ("", _SENSOR, ""),
            "sensors of unknown devices": ("", '<sensor name="S#" device="d#"/>', ""),
            "actuators": ("", '<actuator name="A#" device="lamp"><procedure name="On"/></actuator>', ""),
            "procedures of one actuator": (
                '<actuator name="A" device="lamp">',
                '<procedure name="P#"/>',
                "</actuator>",
            ),
            "procedures that stop nothing": (
                '<actuator name="A" device="lamp">',
                '<procedure name="P#" completes="later" stop="Q#"/>',
                "</actuator>",
            ),
            "procedures that stop one another": (
                '<actuator name="A" device="lamp">',
                '<procedure name="P#" completes="later" stop="P0"/>',
                "</actuator>",
            ),
            "parameters of one procedure": (
                '<actuator name="A" device="lamp"><procedure name="P">',
                '<parameter name="p#" min="0" max="9"/>',
                "</procedure></actuator>",
            ),
            "variables": ("", '<variable name="V#" min="0" max="9" initial="0"/>', ""),
            "boolean variables": ("", '<variable name="V#" type="boolean" initial="true"/>', ""),
            "boards": ("", '<board name="b#"/>', ""),
            "unknown things": ("", "<thing/>", ""),
            "labels": ("", '<label xml:lang="l#">x</label>', ""),
        }.items()
    },
)

_GROUP = '<constructors version="1"><group name="G" colour="loop">\n'
lines(
    "constructors.xml",
    {
        what: (
            _GROUP + before,
            one + "\n",
            after + "</group></constructors>\n",
        )
        for what, (before, one, after) in {
            "constructors": ("", '<constructor name="C#"><code>3*(WAIT(1);)</code></constructor>', ""),
            "constructors of one name": (
                "",
                '<constructor name="C"><code>3*(WAIT(1);)</code></constructor>',
                "",
            ),
            "constructors with slots": (
                "",
                '<constructor name="C#"><flow name="body"/><code>3*({body})</code></constructor>',
                "",
            ),
            "slots of one constructor": (
                '<constructor name="C">',
                '<flow name="s#"/>',
                "<code>3*({s0})</code></constructor>",
            ),
            "holes that are no slots": (
                '<constructor name="C"><code>',
                "3*({s#});",
                "</code></constructor>",
            ),
            "constructors with a hole twice": (
                "",
                '<constructor name="C#"><flow name="s"/><code>{s}{s}</code></constructor>',
                "",
            ),
            "codes that are no LLL": ("", '<constructor name="C#"><code>?(</code></constructor>', ""),
            "groups": ("", '</group><group name="K#" colour="loop">', ""),
            "unknown things": ("", "<thing/>", ""),
        }.items()
    },
)

_STEP = "<step><label>Do</label><help>Do it.</help><contains><code>Wheel.Advance({speed})</code></contains></step>"
lines(
    "tutorial.xml",
    {
        what: ('<tutorial version="1"><label>T</label><help>T.</help>\n' + before, one + "\n", after + "</tutorial>\n")
        for what, (before, one, after) in {
            "steps": ("", _STEP, ""),
            "steps that are empty": ("", "<step/>", ""),
            "unknown things": ("", "<thing/>", ""),
            "patterns of one step": (
                "<step><label>Do</label><help>Do it.</help>",
                "<contains><code>Wheel.Stop()</code></contains>",
                "</step>",
            ),
            "ranges of one pattern": (
                "<step><label>Do</label><help>Do it.</help><contains><code>Wheel.Advance({s})</code>",
                '<hole name="h#" min="1" max="2"/>',
                "</contains></step>",
            ),
            "instructions of one pattern": (
                "<step><label>Do</label><help>Do it.</help><contains><code>",
                "Wheel.Stop();",
                "</code></contains></step>",
            ),
        }.items()
    },
)

lines(
    "exercise.xml",
    {
        what: ('<exercise version="1" start="x.krt"><label>E</label>\n' + before, one + "\n", after + "</exercise>\n")
        for what, (before, one, after) in {
            "goals": ("", '<uses part="Wheel.Advance"><label>G #</label></uses>', ""),
            "goals that lack all": ("", "<visits/>", ""),
            "times longer than a run": ("", '<within seconds="600"><label>G</label></within>', ""),
            "seeds": ("<done><label>D</label></done>", '<seed value="#"/>', ""),
            "seeds of one value": ("<done><label>D</label></done>", '<seed value="1"/>', ""),
            "unknown properties": ("", '<holds property="p#"><label>H</label></holds>', ""),
            "labels of one goal": ("<done>", '<label xml:lang="fr">D #</label>', "<label>D</label></done>"),
            "unknown things": ("", "<thing/>", ""),
        }.items()
    },
)

lines(
    "xml",
    {
        "comments before the first element": ("", "<!-- -->", "<robot/>"),
        "instructions before the first element": ("", "<?x y?>", "<robot/>"),
        "comments that do not end": ("", "<!-- ", ""),
        "document types": ("", "<!DOCTYPE x [", ""),
        "entities": ("<robot>", "&amp;", "</robot>"),
        "unknown entities": ("<robot>", "&x;", "</robot>"),
        "elements in one another": ("", "<robot>", ""),
        "spaces": ("", " ", ""),
        "angles": ("", "<", ""),
    },
)
