"""Whoever looks on: what became of claims, what is odd, what is drawn and written."""

from __future__ import annotations

import json
import logging
from typing import Any, Dict, List, Mapping, Sequence

import numpy as np

from rqt_mrta_py.hooks import (
    AllocationSign,
    AllocationStarted,
    Chart,
    Curve,
    CurveGroup,
    CurvePanel,
    ExporterSetup,
    Fact,
    Figure,
    FigureSetup,
    GroundsSetup,
    Heard,
    IncidentBoard,
    InterpreterSetup,
    Line,
    LineStyle,
    MeasureSetup,
    MonitorView,
    ObserverSetup,
    PanelSetup,
    RuleSetup,
    Subscription,
)
from rqt_mrta_py.model import Ground, MissionRecord, Outcome, Severity

LOG = logging.getLogger("stranger")

MILEAGE = Subscription("/@robot_id@/mileage", "std_msgs/Float64", ("data",))
LATE_BY = Subscription("/@robot_id@/late_by", "std_msgs/Float64", ("data",))
CLAIMS = Subscription("/@robot_id@/claim/@task_id@", "std_msgs/String", ("data",))
RANK = Subscription("/@robot_id@/rank", "std_msgs/Int32", ("data",))
FELT = Subscription("/@robot_id@/felt", "std_msgs/Float64", ("data",))
FAREWELLS = Subscription("/@robot_id@/farewell/@task_id@", "std_msgs/String", ("data",))


class Interpreter:
    def __init__(self, setup: InterpreterSetup) -> None:
        self.robots = setup.robots

    def subscriptions(self) -> Sequence[Subscription]:
        return [FAREWELLS]

    def hear(self, heard: Heard) -> Sequence[AllocationSign]:
        return [AllocationSign(heard.robot, heard.task, Outcome.GAVE_UP, heard.fields["data"])]


class SomebodyWorks:
    def __init__(self, setup: RuleSetup) -> None:
        self._place = setup.mission.application.name
        self.causes = f"moles that take it up within {setup.pace.uptake:g} s"

    def subscriptions(self) -> Sequence[Subscription]:
        return ()

    def hear(self, heard: Heard, board: IncidentBoard) -> None:
        pass

    def notice(self, fact: Fact, board: IncidentBoard) -> None:
        if isinstance(fact, AllocationStarted):
            board.open(fact.robot, Severity.INFO, fact.time, f"work in the {self._place}", robots=[fact.robot])

    def wake(self, time: float, board: IncidentBoard) -> None:
        pass

    def finish(self, time: float, board: IncidentBoard) -> None:
        pass


class MileagePanel:
    def __init__(self, setup: PanelSetup) -> None:
        self._heard: List[Heard] = []

    def subscriptions(self) -> Sequence[Subscription]:
        return [MILEAGE]

    def hear(self, heard: Heard) -> None:
        self._heard.append(heard)

    def view(self, start: float, end: float) -> CurvePanel:
        heard = [each for each in self._heard if start <= each.receipt <= end and each.robot == "mole1"]
        curve = Curve("mileage", tuple(e.receipt for e in heard), tuple(e.fields["data"] for e in heard))
        return CurvePanel("Mileage", "m", 3.0, None, (CurveGroup("mole1", (curve,)),))


def draw(view: MonitorView) -> Any:
    """Paint as grey as there are points in the panel."""
    return np.full((8, 16, 3), len(view.panels[0].groups[0].curves[0].times), dtype=np.uint8)


class Trace:
    def __init__(self, setup: ExporterSetup) -> None:
        self._heard: Dict[str, List[Any]] = {"application": [setup.mission.application.name]}

    def subscriptions(self) -> Sequence[Subscription]:
        return [MILEAGE, RANK, LATE_BY, CLAIMS, FELT]

    def hear(self, heard: Heard) -> None:
        self._heard.setdefault(heard.topic, []).append(heard.fields["data"])

    def export(self, record: MissionRecord) -> Mapping[str, bytes]:
        return {"trace.json": json.dumps({**self._heard, "allocations": len(record.allocations)}).encode()}


class Tunnels:
    """One bar for each robot that was heard, as high as its mileage."""

    def __init__(self, setup: FigureSetup) -> None:
        self._dug: Dict[str, float] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        return [MILEAGE]

    def hear(self, heard: Heard) -> None:
        self._dug[heard.robot] = heard.fields["data"]

    def figures(self, record: MissionRecord) -> Sequence[Figure]:
        moles = tuple(sorted(self._dug))
        heights = tuple(self._dug[mole] for mole in moles)
        line = Line("dug", tuple(map(float, range(len(moles)))), heights, style=LineStyle.BARS)
        return [Figure("dug", "Tunnels", "mole", (Chart((line,), "mileage [m]", x_ticks=moles),))]


class Mileage:
    """How far each mole came, and all of them for each allocation."""

    def __init__(self, setup: MeasureSetup) -> None:
        self._dug = dict.fromkeys((robot.id for robot in setup.mission.application.robots), 0.0)

    def subscriptions(self) -> Sequence[Subscription]:
        return [MILEAGE]

    def hear(self, heard: Heard) -> None:
        self._dug[heard.robot] = heard.fields["data"]

    def value(self, record: MissionRecord) -> Dict[str, float]:
        return {**self._dug, "each": sum(self._dug.values()) / len(record.allocations)}


class Reasons:
    """Each first claim, with what it was at."""

    def __init__(self, setup: GroundsSetup) -> None:
        self._place = setup.mission.application.name
        self._told: Dict[str, str] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        return [CLAIMS]

    def hear(self, heard: Heard) -> Sequence[Ground]:
        if self._told.get(heard.robot) == heard.task:
            return ()
        self._told[heard.robot] = heard.task
        return [Ground(heard.receipt, heard.task, f"dug for {heard.fields['data']} in the {self._place}", heard.robot)]


class Ear:
    def __init__(self, setup: ObserverSetup) -> None:
        LOG.info("an ear in the %s", setup.mission.application.name)

    def subscriptions(self) -> Sequence[Subscription]:
        return [FAREWELLS]

    def hear(self, heard: Heard) -> None:
        if heard.ordinal == 0:
            LOG.info("heard of %s: %s", heard.robot, heard.fields["data"])
