"""Whom a builder asks."""

from __future__ import annotations

from typing import Mapping, NamedTuple, Optional

from block_construction.building.seams import Board, Traffic
from block_construction.building.site_map import SiteMap
from block_construction.team.board import TeamBoard
from block_construction.team.lingering import Placement
from block_construction.team.traffic import Traffic as TeamTraffic
from rqt_mrta_py.hooks import ArmModel

__all__ = ["Helpers", "Team"]


class Team(NamedTuple):
    """What a builder needs that is not alone.

    Attributes:
        robot: its id.
        board: knows the teammates.
        traffic: plans ways among them.
        tasks: of the build, by id.
    """

    robot: str
    board: TeamBoard
    traffic: TeamTraffic
    tasks: Mapping[str, Placement]


class Helpers(NamedTuple):
    """Whom a builder asks.

    Attributes:
        arm: of the robot.
        traffic: about ways.
        board: about others.
        site: about blocks.
        team: what only those ask who are not alone.
    """

    arm: ArmModel
    traffic: Traffic
    board: Board
    site: SiteMap
    team: Optional[Team] = None
