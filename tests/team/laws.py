"""The laws of the protocol, each a property of one state of `three`, and what must be true in the end."""

from __future__ import annotations

from kitrobot.team import Member
from kitrobot.team.meeting import combined
from tests.team.three import MEMBERS, Faults, Law, Team, Three


def a_log_has_one_beginning(model: Three, team: Team) -> bool:
    """Of two members, what one knows to be decided is what the other knows: slot by slot, and the tables made of it."""
    return all(_agree(model, team.members[a], team.members[b]) for a in MEMBERS for b in range(a))


def a_slot_and_so_a_view_is_agreed_by_a_majority_of_the_view_before(model: Three, team: Team) -> bool:
    """Of the seats of the view that decides a slot, more than half voted for it (or know that it is decided)."""
    return all(_voted(model, team, number) for number in team.members)


def no_two_members_may_act_in_one_role(model: Three, team: Team) -> bool:
    """At every moment at most so many members have the right to act in a role as are wanted; here one."""
    roles = range(len(model.plan.charter.roles))
    return all(sum(model.acting(team.members[m], role) for m in MEMBERS if m != team.down) <= 1 for role in roles)


def a_meeting_is_over_when_all_have_come_or_left(model: Three, team: Team) -> bool:
    """Who is in the view and in the meeting's group has announced, where a member knows that the meeting is over."""
    for number in team.members:
        tables = model.states[number].tables
        for rule, meeting in zip(model.plan.charter.meetings, tables.meetings, strict=True):
            present = {m for group in rule.groups for m in tables.groups[group] if tables.view.has(m)}
            if meeting.results and not all(team.programs[member].came for member in present):
                return False
    return True


def a_question_has_one_answer_and_it_is_that_of_those_who_came(model: Three, team: Team) -> bool:
    """All that know a result know the same one; it combines what was said by some who came and all that stayed."""
    results = {r for n in team.members for meeting in model.states[n].tables.meetings for r in meeting.results}
    if not results:
        return True
    came = [member for member in MEMBERS if team.programs[member].came]
    stayed = {m for m in came if all(model.states[n].tables.view.has(m) for n in team.members)}
    sets = [[m for m in came if m in stayed or mask >> m & 1] for mask in range(1 << len(MEMBERS))]
    quantifier = model.plan.charter.meetings[0].quantifier
    possible = {combined(quantifier, [model.plan.answers[m] for m in who]) for who in sets}
    return len(results) == 1 and results.pop().answer in possible


def a_unit_is_done_by_its_last_holder(model: Three, team: Team) -> bool:
    """A unit is done only if a member was given it under the number that it had last, and said that it is done."""
    said = {unit for program in team.programs for unit in program.said}
    return all(
        not unit.done or (index, unit.number) in said
        for number in team.members
        for work in model.states[number].tables.works
        for index, unit in enumerate(work.units)
    )


LAWS: tuple[Law, ...] = (
    a_log_has_one_beginning,
    a_slot_and_so_a_view_is_agreed_by_a_majority_of_the_view_before,
    no_two_members_may_act_in_one_role,
    a_meeting_is_over_when_all_have_come_or_left,
    a_question_has_one_answer_and_it_is_that_of_those_who_came,
    a_unit_is_done_by_its_last_holder,
)


def _agree(model: Three, a: int, b: int) -> bool:
    key = "agree", min(a, b), max(a, b)
    if key not in model.known:
        one, two = model.states[a], model.states[b]
        first = max(one.log.slot - len(one.log.kept), two.log.slot - len(two.log.kept))
        last = min(one.log.slot, two.log.slot)
        model.known[key] = _kept(one, first, last) == _kept(two, first, last) and (
            one.log.slot != two.log.slot or one.tables == two.tables
        )
    return model.known[key]


def _kept(state: Member, first: int, last: int) -> tuple[object, ...]:
    start = state.log.slot - len(state.log.kept)
    return state.log.kept[first - start : max(first, last) - start]


def _voted(model: Three, team: Team, number: int) -> bool:
    """Whether the last slot that this member knows has the votes of a majority of those who decide it."""
    key = "voted", number, team.members
    if key not in model.known:
        state = model.states[number]
        slot = state.log.slot - 1
        if slot < 0:
            return True
        value = state.log.kept[-1]
        others = [model.states[other].log for other in team.members]
        deciding = model.view(state.log.kept[:-1]).seats
        votes = [
            rank
            for rank, seat in enumerate(deciding)
            for log in (others[seat.member],)
            if log.slot > slot or (log.slot == slot and log.decision.value == value)
        ]
        model.known[key] = is_majority(votes, len(deciding))
    return model.known[key]


def is_majority(ranks: list[int], of: int) -> bool:
    """More than half, or half with the first, as the protocol's document says it."""
    return 2 * len(ranks) > of or (2 * len(ranks) == of and 0 in ranks)


# What must be true in the end, when nothing goes wrong any more.


def unsettled(model: Three, team: Team) -> str:
    """What a healed team still lacks; "" if nothing."""
    states = [model.states[team.members[m]] for m in MEMBERS if m != team.down]
    first = states[0]
    if any(state.tables != first.tables or state.log.slot != first.log.slot for state in states):
        return "all know the same log"
    if {state.seat for state in states} != set(first.tables.view.seats):
        return "all that run, and nobody else, are in the view"
    if any(not state.membership.heard or state.log.pending for state in states):
        return "all hear a quorum, and nothing waits to be decided"
    for meeting in first.tables.meetings:
        if any(state.standing for state in states) or (not meeting.results and meeting.announced):
            return "a meeting to which somebody came is over, and all that stand at it are told"
    for work in first.tables.works:
        if any(unit.holder == team.down >= 0 for unit in work.units) or (work.waiting and work.left):
            return "every unit is held by one that runs, and who waits is given one"
    for role in range(len(model.plan.charter.roles)):
        acting = tuple(m for m in MEMBERS if m != team.down and model.acting(team.members[m], role))
        if not acting or acting != first.tables.players[role]:
            return "who plays a role has the right to act in it"
    return ""


def can_decide(model: Three, team: Team) -> bool:
    """Whether a majority of the newest view runs; nobody promises anything where it crashed for good."""
    newest = max((model.states[number].tables.view for number in team.members), key=lambda view: view.number)
    return is_majority([rank for rank, seat in enumerate(newest.seats) if seat.member != team.down], len(newest.seats))


def what_stays_undone(model: Three, team: Team, rounds: int = 30) -> str:
    """What is lacking in the end if nothing more goes wrong from this state on; "" if nothing, or if nobody can decide.

    One fair continuation: all hear each other, every letter arrives, every program goes on, time passes.
    """
    now = team._replace(cut=-1, faults=Faults())
    if not can_decide(model, now):
        return ""
    way: list[Team] = []
    lacking = "nothing"
    for _ in range(rounds):
        now = model.quiet(now)
        if ("settles", now) in model.known:
            lacking = ""
            break
        way.append(now)
        lacking = unsettled(model, now)
        if not lacking:
            break
        now = model.time(now)[1]
    if not lacking:
        model.known.update((("settles", one), True) for one in way)
    return lacking


def all_is_done(model: Three, team: Team) -> bool:
    """Whether something was decided, and every program that runs has nothing left to do or to wait for."""
    states = [model.states[team.members[m]] for m in MEMBERS if m != team.down]
    wishes = (wish for m in MEMBERS if m != team.down for wish in model.wishes(team, m))
    works = (work for state in states for work in state.tables.works)
    return (
        not unsettled(model, team)
        and next(wishes, None) is None
        and all(state.log.slot and all(meeting.results for meeting in state.tables.meetings) for state in states)
        and all(unit.done for work in works for unit in work.units)
    )
