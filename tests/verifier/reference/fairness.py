"""Runs that never come to what they wait for: strongly connected parts of the explored graph that are fair.

A run is fair when it puts off no progress class for ever (see `timing`): a tick that would change something all the
time is made in the end; what else is possible again and again comes in the end. Parts are found by Tarjan's algorithm
(1972), without recursion; where something is possible in a part and never comes, its states are left out where it is
possible, and the rest is looked through again (Emerson and Lei, 1987).
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence

from tests.verifier.reference.exploration import StateSpace


def fair_part(made: StateSpace, within: Sequence[int], agents: int) -> list[int] | None:
    """A set of states in which a fair run can stay for ever, or None.

    Args:
        made: what was explored, with its steps; states without all of their steps are left out.
        within: the numbers of the states that count.
        agents: how many there are.
    """
    ticks = (1 << agents) - 1
    others = ((1 << 3 * agents) - 1) & ~ticks
    waiting = [set(within)]
    while waiting:
        for part in _parts(made, waiting.pop()):
            if len(part) == 1 and not _stays(made, part[0]):
                continue
            inside = set(part)
            taken, idle_once, always_idle, forward, backward = 0, 0, -1, 0, 0
            for state in part:
                idle_once |= made.idle[state]
                always_idle &= made.idle[state]
                forward |= made.forward[state]
                backward |= made.backward[state]
                for edge in range(made.first_edge[state], made.first_edge[state + 1]):
                    if made.targets[edge] in inside:
                        taken |= made.taken[edge]
            if ticks & ~(taken | idle_once):
                continue
            starved = others & ~(taken | always_idle)
            # Who rolls one way, again and again, and stays in its zone.
            caught = (forward ^ backward) & ~(taken >> 3 * agents)
            if not starved and not caught:
                return part
            rest = {
                state
                for state in part
                if not starved & ~made.idle[state] and not caught & (made.forward[state] | made.backward[state])
            }
            if rest:
                waiting.append(rest)
    return None


def _stays(made: StateSpace, state: int) -> bool:
    """Whether a run can stay in a state: a step leads back to it, or none leads anywhere."""
    following = targets(made, state)
    return state in following or not following


def reachable(made: StateSpace, within: Sequence[bool]) -> list[int]:
    """The states that can be reached from the first one through states that count."""
    if not within or not within[0]:
        return []
    found, seen, at = [0], {0}, 0
    while at < len(found):
        for target in targets(made, found[at]):
            if within[target] and target not in seen:
                seen.add(target)
                found.append(target)
        at += 1
    return found


def targets(made: StateSpace, state: int) -> Sequence[int]:
    """The states after one, where its steps were explored."""
    if state + 1 >= len(made.first_edge):
        return ()
    return made.targets[made.first_edge[state] : made.first_edge[state + 1]]


def way(made: StateSpace, start: int, ends: set[int], within: set[int]) -> list[int]:
    """A shortest way of at least one step from a state to one of others, through states of a set; without the start.
    Empty where there is none.
    """
    before: dict[int, int] = {}
    waiting = deque([start])
    while waiting:
        state = waiting.popleft()
        for target in targets(made, state):
            if target not in within or target in before:
                continue
            before[target] = state
            if target in ends:
                found = [target]
                while before[found[-1]] != start:
                    found.append(before[found[-1]])
                return found[::-1]
            waiting.append(target)
    return []


def _parts(made: StateSpace, within: set[int]) -> Iterator[list[int]]:
    """The strongly connected parts of the graph between these states; a single state is one too."""
    index: dict[int, int] = {}
    low: dict[int, int] = {}
    on_stack: set[int] = set()
    stack: list[int] = []
    for root in within:
        if root in index or root + 1 >= len(made.first_edge):
            continue
        index[root] = low[root] = len(index)
        stack.append(root)
        on_stack.add(root)
        work = [(root, iter(targets(made, root)))]
        while work:
            state, following = work[-1]
            for target in following:
                if target not in within or target + 1 >= len(made.first_edge):
                    continue
                if target not in index:
                    index[target] = low[target] = len(index)
                    stack.append(target)
                    on_stack.add(target)
                    work.append((target, iter(targets(made, target))))
                    break
                if target in on_stack:
                    low[state] = min(low[state], index[target])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[state])
                if low[state] == index[state]:
                    part = []
                    while True:
                        member = stack.pop()
                        on_stack.discard(member)
                        part.append(member)
                        if member == state:
                            break
                    yield part
