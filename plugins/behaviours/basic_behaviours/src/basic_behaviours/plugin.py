"""Registers the behaviours by the kind of task, and the sensory evaluators by name."""

from __future__ import annotations

from typing import Mapping

from basic_behaviours.avoid import Avoid
from basic_behaviours.collect import Collect
from basic_behaviours.evaluators import AllSensorsFresh
from basic_behaviours.follow_border import FollowBorder
from basic_behaviours.go_to_place import GoToPlace
from basic_behaviours.report import Report
from basic_behaviours.wander import Wander
from rqt_mrta_py.hooks import BehaviourFactory, SensoryEvaluatorFactory, hookimpl

__all__ = ["mrta_register_behaviours", "mrta_register_sensory_evaluators"]


@hookimpl
def mrta_register_behaviours() -> Mapping[str, BehaviourFactory]:
    """Name the behaviours."""
    return {
        "avoid": Avoid,
        "collect": Collect,
        "follow_border": FollowBorder,
        "go_to_place": GoToPlace,
        "report": Report,
        "wander": Wander,
    }


@hookimpl
def mrta_register_sensory_evaluators() -> Mapping[str, SensoryEvaluatorFactory]:
    """Name the evaluators."""
    return {"basic_behaviours/all_sensors_fresh": AllSensorsFresh}
