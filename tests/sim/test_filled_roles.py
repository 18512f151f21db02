"""Which robots play which roles when a run begins: the page says the same as the simulator."""

from __future__ import annotations

import json
import random
from pathlib import Path

from kitrobot.lll.tree import RoleDeclaration
from kitrobot.sim.setup.team_tables import TeamMember, assign_roles

HELD = Path(__file__).resolve().parents[2] / "web" / "src" / "model" / "testing" / "filled-roles.json"
"""Random teams and who plays what in them; `python -m tests.sim.test_filled_roles` writes it anew."""

KINDS = ("carrier", "loader")


def _held() -> str:
    chance = random.Random(13)
    teams = []
    for _ in range(60):
        roles = []
        for number in range(chance.randint(1, 5)):
            least = chance.randint(0, 3)
            roles.append(RoleDeclaration(f"r{number}", chance.choice(KINDS), least, least + chance.randint(0, 3)))
        members = [TeamMember(n, f"a{n}", chance.choice(KINDS)) for n in range(chance.randint(0, 8))]
        playing = assign_roles(roles, members)
        teams.append(
            {
                "roles": [{"name": r.name, "robot": r.robot, "least": r.least, "most": r.most} for r in roles],
                "agents": [{"name": one.name, "robot": one.kind} for one in members],
                "playing": {members[robot].name: roles[role].name for robot, role in playing.items()},
            }
        )
    return json.dumps(teams, separators=(",", ":")) + "\n"


def test_the_page_is_tested_against_the_roles_that_the_simulator_fills() -> None:
    assert HELD.read_text() == _held(), "write it anew with `python -m tests.sim.test_filled_roles`"


if __name__ == "__main__":
    HELD.write_text(_held())
