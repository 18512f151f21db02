"""The options of `kitrobot run` and `kitrobot team` that send a run to ROS 2 while it goes on."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated, Final

import typer

from kitrobot.cli.output import print_message
from kitrobot.text.sentences import Sentence
from kitrobot.trace.ros.keys import MOST_DOMAIN, STOP_TOPIC

if TYPE_CHECKING:
    from kitrobot.live.ros_bridge import RosBridge, RosNetwork
    from kitrobot.sim.simulation import Simulation

RosDomain = Annotated[
    int | None,
    typer.Option(
        "--ros",
        metavar="DOMAIN",
        min=0,
        max=MOST_DOMAIN,
        help="Send the run to ROS 2 in this domain while it goes on, in real time.",
        show_default=False,
    ),
]
RosListen = Annotated[
    str | None,
    typer.Option(
        metavar="ENDPOINT",
        help="Where ROS 2 reaches the run; without it tcp/127.0.0.1:7447, this machine alone.",
        show_default=False,
    ),
]
RosRouter = Annotated[
    str | None,
    typer.Option(
        metavar="ENDPOINT", help="Send through this router of ROS 2 (`rmw_zenohd`) instead.", show_default=False
    ),
]

STOPPED_BY_ROS: Final = Sentence("Stopped by a message on `{topic}`.", STOP_TOPIC)


def ros_network(domain: int | None, listen: str | None, router: str | None) -> RosNetwork | None:
    """Where a run is sent; None: nowhere."""
    if domain is None:
        if listen is not None or router is not None:
            raise typer.BadParameter(
                "`--ros-listen` and `--ros-router` are of a run that goes to ROS 2", param_hint="'--ros'"
            )
        return None
    if listen is not None and router is not None:
        raise typer.BadParameter("either this run is the router, or another one is", param_hint="'--ros-router'")
    from kitrobot.live.ros_bridge import LOCAL_ENDPOINT, RosNetwork

    return RosNetwork(domain, LOCAL_ENDPOINT if listen is None else listen, router)


@contextmanager
def ros_bridge(simulation: Simulation, network: RosNetwork | None) -> Iterator[RosBridge | None]:
    """The bridge of a run, where one is wanted."""
    if network is None:
        yield None
        return
    from kitrobot.live.ros_bridge import RosBridge

    bridge = RosBridge(simulation, network)
    try:
        print_message(
            Sentence(
                "the run is at {endpoint}, ROS 2 domain {domain}", network.router or network.listen, network.domain
            )
        )
        yield bridge
    finally:
        bridge.close()
