"""The node ``simulation``: the world of a mission, for agents that are nodes of their own."""

from __future__ import annotations

import logging
from typing import Optional, Sequence

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.live.mission_parameters import StrictReader, live_mission, mission_choice
from rqt_mrta_py.app.live.simulation_loop import SimulationLoop
from rqt_mrta_py.app.nodes.frame import Ending, node_main
from rqt_mrta_py.app.run.collector import rare_collections
from rqt_mrta_py.app.run.world_side import WorldSide
from rqt_mrta_py.transport.ros1 import RosNode

__all__ = ["main"]

_log = logging.getLogger("rqt_mrta_py.app")


def main(argv: Optional[Sequence[str]] = None, host: Optional[Host] = None, level: int = logging.INFO) -> int:
    """Run the node.

    Args:
        argv: arguments without the program's name; None for the process's own.
        host: registry and plugins; None: they are looked for.
        level: from which on log lines are told.

    Returns:
        The exit status: 0 when the mission is over or the node was asked to end.
    """
    return node_main("simulation", _work, argv, host=host, level=level, rosout=False)


def _work(node: RosNode, host: Host, ending: Ending) -> None:
    reader = StrictReader(node.parameter, node.resolve)
    application = reader.require("application", reader.text("application"), "a registered name, or a path")
    choice = mission_choice(reader, application)
    duration = reader.number("duration")
    factor = reader.number("rate_factor")
    lock_step = reader.truth("lock_step", default=False)
    witnesses, awaited = reader.texts("witnesses"), reader.texts("awaited")
    parameters = reader.text("parameters")
    reader.check()
    if not node.parameter("/use_sim_time", False):
        node.set_parameter("/use_sim_time", True)
        _log.warning("use_sim_time was not set: it is now, but nodes that started before keep the wall's time")
    mission = live_mission(node.parameters, host, choice, parameters)
    world = WorldSide(mission, duration, node.codec, host.manager)
    try:
        pace = (0.0 if lock_step else 1.0) if factor is None else factor
        simulation = SimulationLoop(
            node,
            world,
            lambda: ending.wait(0.0),
            lock_step=lock_step,
            factor=pace,
            witnesses=witnesses,
            awaited=awaited,
        )
        with rare_collections():
            simulation.run()
    finally:
        world.close()
