"""The laws of a fleet, each a property of one state of `three_agents`, and what must be true in the end."""

from __future__ import annotations

from kitrobot.sim.tables.columns import ENDED
from kitrobot.sim.tables.team_columns import HAS_UNIT, T_ROLE, TEAM_OVER, W_LEFT
from tests.fleet.three_agents import MEMBERS, Agent, Faults, Law, Team, ThreeAgents


def a_log_has_one_beginning(model: ThreeAgents, team: Team) -> bool:
    """Of two agents, what one knows to be decided is what the other knows, and so are the tables made of it."""
    return all(_agree(model, team.agents[a], team.agents[b]) for a in MEMBERS for b in range(a))


def a_slot_and_so_a_view_is_agreed_by_a_majority_of_the_view_before(model: ThreeAgents, team: Team) -> bool:
    """Of the seats of the view that decides a slot, more than half voted for it (or know that it is decided)."""
    return all(_voted(model, team, number) for number in team.agents)


def no_two_robots_may_act_in_one_place_of_the_team(model: ThreeAgents, team: Team) -> bool:
    """At every moment at most one robot has the right to act in a place, each as it knows the team."""
    acting = [seat for seat in model.rights(team) if seat >= 0]
    return len(acting) == len(set(acting))


LAWS: tuple[Law, ...] = (
    a_log_has_one_beginning,
    a_slot_and_so_a_view_is_agreed_by_a_majority_of_the_view_before,
    no_two_robots_may_act_in_one_place_of_the_team,
)


def _agree(model: ThreeAgents, a: int, b: int) -> bool:
    key = "agree", min(a, b), max(a, b)
    if key not in model.known:
        one, two = model.states[a], model.states[b]
        logs = one.state.log, two.state.log
        first = max(log.slot - len(log.recent) for log in logs)
        last = min(log.slot for log in logs)
        model.known[key] = _kept(one, first, last) == _kept(two, first, last) and (
            one.slot != two.slot or one.rows == two.rows
        )
    agree: bool = model.known[key]
    return agree


def _kept(agent: Agent, first: int, last: int) -> tuple[object, ...]:
    log = agent.state.log
    start = log.slot - len(log.recent)
    return log.recent[first - start : max(first, last) - start]


def _voted(model: ThreeAgents, team: Team, number: int) -> bool:
    """Whether the last slot that this agent knows has the votes of a majority of those who decide it."""
    key = "voted", number, team.agents
    if key not in model.known:
        log = model.states[number].state.log
        slot = log.slot - 1
        if slot < 0:
            return True
        others = [model.states[other].state.log for other in team.agents]
        deciding = model.view(log.recent[:-1]).seats
        votes = [
            rank
            for rank, seat in enumerate(deciding)
            for other in (others[seat.member],)
            if other.slot > slot or (other.slot == slot and other.decision.value == log.recent[-1])
        ]
        model.known[key] = is_majority(votes, len(deciding))
    voted: bool = model.known[key]
    return voted


def is_majority(ranks: list[int], of: int) -> bool:
    """More than half, or half with the first, as the protocol's document says it."""
    return 2 * len(ranks) > of or (2 * len(ranks) == of and 0 in ranks)


# What must be true in the end, when nothing goes wrong any more.


def unsettled(model: ThreeAgents, team: Team) -> str:
    """What a healed team still lacks; "" if nothing."""
    running = [m for m in MEMBERS if m != team.down]
    agents = {m: model.states[team.agents[m]] for m in running}
    first = agents[running[0]]
    if any(one.state.log.slot != first.state.log.slot or one.rows != first.rows for one in agents.values()):
        return "all know the same log"
    if {one.state.seat for one in agents.values()} != set(first.state.tables.view.seats):
        return "all that run, and nobody else, are in the view"
    if any(not one.state.membership.heard or one.state.log.pending or one.unsent for one in agents.values()):
        return "all hear a quorum, and nothing waits to be decided"
    bench = model.benches[running[0]]
    bench.restore(first, first.state.now)
    state = bench.host.replica.state
    if state.team.numbers[TEAM_OVER]:
        return ""
    for holds in state.team.holds:
        if any(one == HAS_UNIT and (m == team.down or state.robots.ints[ENDED][m]) for m, one in enumerate(holds)):
            return "every unit is held by a robot that runs"
    if any(k >= 0 for waits in state.team.waits for k in waits):
        return "no robot waits for a unit"
    if not all(state.robots.ints[ENDED][m] for m in running):
        return "every program comes to its end"
    playing = {m for m in running if state.team.robots[T_ROLE][m] >= 0}
    if {m for m in running if model.seat(m, team.agents[m]) >= 0} != playing:
        return "a robot that plays a role has the right to act in it"
    return ""


def can_decide(model: ThreeAgents, team: Team) -> bool:
    """Whether a majority of the newest view runs; nobody promises anything where it crashed for good."""
    views = (model.states[number].state.tables.view for number in team.agents)
    newest = max(views, key=lambda view: view.number)
    return is_majority([rank for rank, seat in enumerate(newest.seats) if seat.member != team.down], len(newest.seats))


def what_stays_undone(model: ThreeAgents, team: Team, rounds: int = 80) -> str:
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


def all_is_done(model: ThreeAgents, team: Team) -> bool:
    """Whether nothing is left to do: the team is settled, and all units of work are done."""
    if team.letters or unsettled(model, team):
        return False
    agent = next(model.states[team.agents[m]] for m in MEMBERS if m != team.down)
    model.benches[0].restore(agent, agent.state.now)
    return not any(model.benches[0].host.replica.state.team.works[W_LEFT])
