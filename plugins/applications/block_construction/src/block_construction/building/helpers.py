"""Whom a builder asks."""

from __future__ import annotations

from typing import NamedTuple, Optional

from block_construction.building.seams import Traffic
from block_construction.building.site_map import SiteMap
from block_construction.building.teamwork import Team
from rqt_mrta_py.hooks import ArmModel

__all__ = ["Helpers"]


class Helpers(NamedTuple):
    """Whom a builder asks.

    Attributes:
        arm: of the robot.
        traffic: about ways.
        site: about blocks.
        team: what only those ask who are not alone.
    """

    arm: ArmModel
    traffic: Traffic
    site: SiteMap
    team: Optional[Team] = None
