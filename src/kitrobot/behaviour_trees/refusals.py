"""Standard nodes of BehaviorTree.CPP that no program can say, and ports that every kind of node must have."""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.behaviour_trees.subtrees import BLACKBOARD_HELP
from kitrobot.text.sentences import Help, Sentence


@dataclass(frozen=True)
class Refusal:
    """Why a node is no part of a program, with `{node}` for its name, and what to do instead."""

    reason: Sentence
    help: Help


ASK_FIRST = Sentence("ask before the action: a <Sequence> with a <Condition> first")
SPLIT_HELP = Sentence("put it into <ForceSuccess>, or ask its conditions at the beginning of a <Sequence>")
BLACKBOARD = Refusal(Sentence("works with the blackboard, and a program has none"), BLACKBOARD_HELP)
INTERRUPTION = Refusal(
    Sentence("stops what is under way when an answer changes, and a program ends each action first"),
    Sentence("use the node without `Reactive`, and ask between shorter actions"),
)
FAILURE = Refusal(Sentence("counts on actions that fail, and the actions of a KitRobot never fail"), ASK_FIRST)
OTHER = Refusal(
    Sentence("has no counterpart in a program"),
    Sentence("build it of {nodes}", "`Sequence`, `Fallback`, `IfThenElse`, `Parallel`, `Repeat`, `Inverter`, `Sleep`"),
)

REFUSED = {
    **dict.fromkeys(("Script", "ScriptCondition", "Precondition", "SetBlackboard", "UnsetBlackboard"), BLACKBOARD),
    **dict.fromkeys(("EntryUpdated", "SkipUnlessUpdated", "WaitValueUpdate", "ConsumeQueue"), BLACKBOARD),
    **dict.fromkeys((f"Switch{count}" for count in range(2, 7)), BLACKBOARD),
    **dict.fromkeys((f"Loop{kind}" for kind in ("Int", "Double", "String", "Bool")), BLACKBOARD),
    **dict.fromkeys(("WhileDoElse", "Timeout"), INTERRUPTION),
    "ForceFailure": FAILURE,
    **dict.fromkeys(("TryCatch", "Finally", "LatchedSequence", "LatchedFallback"), OTHER),
    **dict.fromkeys(("SequenceWithMemory", "SequenceStar", "RunOnce", "ManualSelector", "TestNode"), OTHER),
}
CHILDREN = {
    **dict.fromkeys(("Inverter", "ForceSuccess", "Delay", "Repeat"), (1, 1)),
    **dict.fromkeys(("RetryUntilSuccessful", "KeepRunningUntilFailure"), (1, 1)),
    **dict.fromkeys(("Sleep", "AlwaysSuccess", "AlwaysFailure"), (0, 0)),
    "IfThenElse": (2, 3),
    **dict.fromkeys(("Sequence", "AsyncSequence", "ReactiveSequence", "Parallel", "ParallelAll"), (1, None)),
    **dict.fromkeys(("Fallback", "AsyncFallback", "ReactiveFallback"), (1, None)),
}
"""How many nodes are inside the standard nodes that a program can say: least and most."""
