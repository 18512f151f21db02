"""The rules of meaning: what can be wrong with a program whose text or graph can be read."""

from kitrobot.diagnostics.model import Severity, rule

UNKNOWN_OBJECT = rule(
    "unknown-object",
    Severity.ERROR,
    "The robot has no object of that name",
    "Objects (actuators, sensors, variables) come from the robot's XML file. Case matters.",
)
UNKNOWN_METHOD = rule(
    "unknown-method",
    Severity.ERROR,
    "The object has no method of that name",
    "What an object can do or tell is written in the robot's XML file. Case matters.",
)
PARAMETER_COUNT = rule(
    "parameter-count",
    Severity.ERROR,
    "A call has too few or too many parameters",
    "Each method takes exactly the parameters that the robot's XML file names.",
)
OUT_OF_RANGE = rule(
    "out-of-range",
    Severity.ERROR,
    "A number is outside the range of what it is given to",
    "A number written for a procedure or for Set must lie within the range in the robot's XML file. A number that is "
    "computed while the program runs is clamped to the range instead, and raises the fault flag.",
)
TEST_FOR_VALUE = rule(
    "test-for-value",
    Severity.ERROR,
    "A test stands where a number is needed",
    "A test is true or false. A number is a literal or what a value such as Captor.Value() gives.",
)
VALUE_FOR_TEST = rule(
    "value-for-test",
    Severity.ERROR,
    "A number stands where a test is needed",
    "A condition, and what is given to a boolean, is a test such as Button.IsPressed(), or 0 or 1 for a boolean.",
)
PROCEDURE_FOR_VALUE = rule(
    "procedure-for-value",
    Severity.ERROR,
    "An action stands where a test or a number is needed",
    "A procedure does something and gives nothing back. Conditions and parameters only read.",
)
VALUE_AS_INSTRUCTION = rule(
    "value-as-instruction",
    Severity.HINT,
    "A test or value stands as an instruction",
    "Reading something without using it does nothing.",
)
BREAK_OUTSIDE_LOOP = rule(
    "break-outside-loop",
    Severity.HINT,
    "BREAK stands outside a loop",
    "BREAK leaves the innermost loop of its branch. With none it ends the branch, or the program.",
)
MARK_OUTSIDE_PARALLEL = rule(
    "mark-outside-parallel",
    Severity.HINT,
    "A marked action stands outside a parallel",
    "The mark ° says that a branch may be interrupted. Outside a parallel there is no branch, and it does nothing.",
)
SHARED_ACTUATOR = rule(
    "shared-actuator",
    Severity.HINT,
    "Two branches of one parallel drive the same actuator",
    "An actuator takes one command a tick: the last branch wins. This may be meant; often it is not.",
)
NEVER_RUNS = rule(
    "never-runs",
    Severity.HINT,
    "An instruction can never run",
    "Nothing leads here: it follows a BREAK or something that never ends, or stands in a loop of 0 times.",
)
OVERWRITTEN = rule(
    "overwritten",
    Severity.HINT,
    "A command gives way in the tick in which it is given",
    "An actuator takes one command a tick, and the last one wins. Where nothing that takes time stands between two "
    "commands of one actuator, the first has no effect.",
)
IDLE_LOOP = rule(
    "idle-loop",
    Severity.HINT,
    "A loop without end has nothing in it that takes time",
    "A loop whose body takes no time makes one pass a tick. Where it does nothing, and nothing leaves it, the robot "
    "stays as it is for ever; where it looks at nothing, it does the same again in every tick.",
)
TOO_LARGE = rule(
    "too-large",
    Severity.ERROR,
    "The program is larger than an image can hold",
    "An image holds 256 cells (inputs, variables, counters, constants), 256 slots, 256 parallels, 256 marked actions, "
    "256 procedures with 255 parameters each, and 65536 instructions. Parts that are used often are counted before "
    "they are put in their places; all programs of a mission may grow by twice as many.",
)
