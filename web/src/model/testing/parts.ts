/** A catalogue for tests: the paper's constructors and the carrier, as the server would send them. */
import type { Catalogue, Colour, Constructor, Method, Parameter, RobotObject, Slot } from "../types";

function slot(name: string, kind: Slot["kind"], more: Partial<Slot> = {}): Slot {
  return {
    name,
    kind,
    label: {},
    loop: false,
    repeat: false,
    least: 0,
    min: null,
    max: null,
    default: "",
    unit: "",
    ...more,
  };
}

function constructor_(
  group: string,
  colour: Colour,
  name: string,
  icon: string,
  slots: Slot[],
  code: string,
  more: Partial<Constructor> = {},
): Constructor {
  return { name, group, icon, colour, label: {}, help: {}, slots, role: "instruction", adds: null, code, ...more };
}

const condition = slot("condition", "condition");

const loops = [
  constructor_(
    "Loops",
    "loop",
    "Repetition",
    "repeat",
    [
      slot("count", "number", { min: 0, max: 65535, default: "10", unit: "×" }),
      slot("body", "flow", { loop: true, label: { "": "do" } }),
    ],
    "{count}*({body})",
  ),
  constructor_(
    "Loops",
    "loop",
    "While",
    "rotate-cw",
    [condition, slot("body", "flow", { loop: true, label: { "": "do" } })],
    "*[{condition}]({body})",
  ),
  constructor_("Loops", "loop", "Break", "log-out", [], "BREAK"),
];

const choices = [
  constructor_(
    "Choices",
    "choice",
    "If Then",
    "split",
    [condition, slot("then", "flow", { label: { "": "yes" } })],
    "[{condition}]({then})",
  ),
  constructor_(
    "Choices",
    "choice",
    "If Then Else",
    "git-fork",
    [condition, slot("then", "flow", { label: { "": "yes" } }), slot("else", "flow", { label: { "": "no" } })],
    "[{condition}]({then})!({else})",
  ),
  constructor_("Choices", "choice", "When", "bell", [condition, slot("body", "flow")], "<{condition}>({body})", {
    help: { "": "Waits until the condition holds, then does the body once." },
  }),
  constructor_(
    "Choices",
    "choice",
    "Wait",
    "timer",
    [slot("time", "number", { min: 0, max: 65535, default: "10", unit: "× 0.1 s" })],
    "WAIT({time})",
  ),
];

const parallels = [
  constructor_(
    "Parallel",
    "parallel",
    "Parallelism",
    "columns-2",
    [slot("branch", "flow", { repeat: true, least: 2 })],
    "//({branch})",
  ),
  constructor_("Parallel", "parallel", "Branch", "between-vertical-start", [], "", {
    role: "branch",
    adds: { constructor: "Parallelism", slot: "branch" },
  }),
  constructor_("Parallel", "parallel", "Interrupt", "zap", [slot("action", "action")], "°{action}°", {
    label: { "": "Interruptible" },
    help: { "": "Its branch ends when the others have." },
  }),
];

const conditions = [
  constructor_(
    "Conditions",
    "test",
    "And",
    "ampersand",
    [slot("left", "condition"), slot("right", "condition")],
    "{left}&{right}",
    { role: "condition" },
  ),
  constructor_(
    "Conditions",
    "test",
    "Or",
    "slash",
    [slot("left", "condition"), slot("right", "condition")],
    "{left}|{right}",
    { role: "condition" },
  ),
  constructor_("Conditions", "test", "No", "ban", [condition], "!({condition})", { role: "condition" }),
];

const percent: Parameter = {
  name: "speed",
  kind: "integer",
  min: 0,
  max: 100,
  default: 50,
  unit: "%",
  label: {},
  help: { "": "How fast the wheels turn: 0 stands still, 100 is full speed." },
};

function method(name: string, kind: Method["kind"], icon: string, more: Partial<Method> = {}): Method {
  return {
    name,
    kind,
    label: {},
    help: {},
    icon,
    parameters: [],
    completes_later: false,
    stop: null,
    phrase: {},
    ...more,
  };
}

function object(
  name: string,
  category: RobotObject["category"],
  icon: string,
  methods: Method[],
  more: Partial<RobotObject> = {},
): RobotObject {
  return {
    name,
    category,
    look: "",
    hand: "",
    icon,
    label: {},
    help: {},
    methods,
    type: "integer",
    min: 0,
    max: 1,
    initial: 0,
    shared: false,
    ...more,
  };
}

const button = [
  method("IsPressed", "test", "", { phrase: { "": "{object} pressed" }, test: "equal", to: 1 }),
  method("IsReleased", "test", "", { phrase: { "": "{object} released" }, test: "equal", to: 0 }),
];

function number(name: string, max: number): Parameter {
  return { name, kind: "integer", min: 0, max, default: 0, unit: "", label: {}, help: {} };
}

const comparisons = (max: number) => [
  method("EqualTo", "test", "", {
    parameters: [number("value", max)],
    phrase: { "": "{object} = {value}" },
    test: "equal",
  }),
  method("LessThan", "test", "", {
    parameters: [number("value", max)],
    phrase: { "": "{object} < {value}" },
    test: "less",
  }),
  method("GreaterThan", "test", "", {
    parameters: [number("value", max)],
    phrase: { "": "{object} > {value}" },
    test: "greater",
  }),
  method("Value", "value", "", { phrase: { "": "{object}" } }),
];

export const PARTS: Catalogue = {
  problems: [],
  groups: [
    { name: "Move", colour: "action", label: {}, icon: "arrow-up", constructors: [] },
    { name: "Sense", colour: "test", label: {}, icon: "radar", holds: "sensors", constructors: [] },
    { name: "Actions", colour: "action", label: {}, icon: "zap", holds: "actuators", constructors: [] },
    { name: "Loops", colour: "loop", label: {}, constructors: loops },
    { name: "Choices", colour: "choice", label: {}, constructors: choices },
    { name: "Parallel", colour: "parallel", label: {}, constructors: parallels },
    { name: "Conditions", colour: "test", label: {}, holds: "values", constructors: conditions },
  ],
  robots: [
    {
      name: "carrier",
      label: {},
      help: {},
      tick_ms: 20,
      wait_unit_ms: 100,
      objects: [
        object("Wheel", "actuator", "loader-pinwheel", [
          method("Advance", "procedure", "arrow-up", {
            parameters: [percent],
            stop: "Stop",
            help: { "": "Drives forward until Stop." },
          }),
          method("Reverse", "procedure", "arrow-down", { parameters: [percent], stop: "Stop" }),
          method("Stop", "procedure", "square"),
        ]),
        object("Motor", "actuator", "rotate-3d", [
          method("AbsoluteTurn", "procedure", "rotate-cw", {
            completes_later: true,
            parameters: [{ ...percent, name: "angle" }, percent],
          }),
        ]),
        object("Lamp", "actuator", "lightbulb", [
          method("LightOn", "procedure", "lightbulb", { stop: "LightOff" }),
          method("LightOff", "procedure", "lightbulb-off"),
        ]),
        object("Sign", "sensor", "signpost", comparisons(7), { max: 7 }),
        object("Collision", "sensor", "radar", button),
        object("Cargo", "sensor", "package", button),
        object(
          "Run",
          "variable",
          "toggle-right",
          [
            method("Set", "procedure", "", {
              parameters: [
                { name: "value", kind: "boolean", min: 0, max: 1, default: 1, unit: "", label: {}, help: {} },
              ],
            }),
            method("IsTrue", "test", "", { phrase: { "": "{object} is true" }, test: "equal", to: 1 }),
            method("IsFalse", "test", "", { phrase: { "": "{object} is false" }, test: "equal", to: 0 }),
          ],
          { type: "boolean", initial: 1 },
        ),
        object(
          "Count",
          "variable",
          "hash",
          [
            method("Set", "procedure", "", { parameters: [number("value", 100)] }),
            method("Add", "procedure", "", { parameters: [number("value", 100)] }),
            ...comparisons(100),
          ],
          { max: 100 },
        ),
      ],
    },
  ],
};
