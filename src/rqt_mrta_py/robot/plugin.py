"""What this room brings, registered like anything that strangers bring."""

from __future__ import annotations

from typing import Mapping

from rqt_mrta_py.hooks import Navigator, PlannerFactory, PlannerSetup, hookimpl

__all__ = ["mrta_register_planners"]


@hookimpl
def mrta_register_planners() -> Mapping[str, PlannerFactory]:
    """Name the planner on an occupancy grid."""
    return {"astar": _astar}


def _astar(setup: PlannerSetup) -> Navigator:
    from rqt_mrta_py.robot.navigation import GridNavigator

    if isinstance(setup.previous, GridNavigator):
        setup.previous.replace_obstacles(setup.obstacles)
        return setup.previous
    return GridNavigator(setup.arena, setup.obstacles, radius=setup.radius)
