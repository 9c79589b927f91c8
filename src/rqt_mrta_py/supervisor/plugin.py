"""What the supervisor itself registers, through the hooks that everybody uses."""

from __future__ import annotations

from typing import Mapping

from rqt_mrta_py.hooks import IncidentRuleFactory, Statistic, hookimpl
from rqt_mrta_py.supervisor.rules import RobotSilentWithTask
from rqt_mrta_py.supervisor.statistics import STATISTICS

__all__ = ["mrta_register_incident_rules", "mrta_register_statistics"]


@hookimpl
def mrta_register_incident_rules() -> Mapping[str, IncidentRuleFactory]:
    """Name the rules of the house."""
    return {"robot_silent_with_task": RobotSilentWithTask}


@hookimpl
def mrta_register_statistics() -> Mapping[str, Statistic]:
    """Name the statistics of the house."""
    return STATISTICS
