"""The exporter ``alliance_plots``: definitions of plots for two programs that watch ALLIANCE live, or look at its bags.

For rqt_multiplot what the node high_level of the package alliance writes when it starts: ``<robot>-motivations.xml``
with a plot for each behaviour set, ``<robot>-<task>-detailed-motivation.xml`` with a plot for each factor of equation
3.8. For PlotJuggler ``plotjuggler_layout.xml`` with the same curves.
"""

from __future__ import annotations

from typing import Dict, List, Mapping, Sequence

from mrta_alliance.file_names import FileNames
from mrta_alliance.inner_life import FLAGS
from mrta_alliance.messages import MOTIVATION_TOPICS, MOTIVATION_TYPE, motivation_topic
from mrta_alliance.multiplot import PlotCurve, RowPlot, multiplot_file
from mrta_alliance.plot_juggler import LayoutCurve, LayoutPlot, LayoutTab, layout_file
from rqt_mrta_py.hooks import ExporterSetup, Heard, Subscription
from rqt_mrta_py.model import MissionRecord, normalise_id, wire_id

__all__ = ["AlliancePlots"]

_SUBSCRIPTION = Subscription(MOTIVATION_TOPICS, MOTIVATION_TYPE, ("header/frame_id", "task_id"))
_MOTIVATION = PlotCurve("Motivation", "motivation")
_THRESHOLD = PlotCurve("Threshold", "threshold", "#ff0000", dashed=True)
_OVERVIEW = (_MOTIVATION, _THRESHOLD)
_FLAG_LIMITS = ("-0.1", "1.1")
_MOST_DETAILED = 20
"""Tabs that show one behaviour set each; where there are more sets, nobody would find one."""


class AlliancePlots:
    """Learns which behaviour sets there are, and writes the definitions of their plots.

    Args:
        setup: the mission, whose behaviour sets have definitions even if nothing is heard of them.
    """

    def __init__(self, setup: ExporterSetup) -> None:
        mission = setup.mission
        self._topics: Dict[str, Dict[str, str]] = {
            robot.id: {
                task.id: f"{wire_id(robot.id)}/{motivation_topic(task.id)}" for task in mission.tasks_of(robot.id)
            }
            for robot in mission.application.robots
        }
        self._heard: Dict[str, Dict[str, str]] = {}

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear: all robots' motivations."""
        return (_SUBSCRIPTION,)

    def hear(self, heard: Heard) -> None:
        """Take in that there is a behaviour set, and on which topic."""
        robot, task = normalise_id(heard.fields["header/frame_id"]) or heard.robot, heard.fields["task_id"]
        for topics in (self._topics, self._heard):
            topics.setdefault(robot, {})[task] = heard.topic

    def export(self, record: MissionRecord) -> Mapping[str, bytes]:
        """Give the definitions by file name; the layout shows what was heard, if anything was."""
        robots, behaviour_sets = FileNames(), FileNames()
        files: Dict[str, bytes] = {}
        for robot, topics in self._topics.items():
            files[f"{robots.unique(robot)}-motivations.xml"] = multiplot_file(
                [_overview(each) for each in topics.values()]
            )
            for task, topic in topics.items():
                name = behaviour_sets.unique(f"{robot}/{task}")
                files[f"{name}-detailed-motivation.xml"] = multiplot_file(_details(wire_id(robot), task, topic))
        if self._heard:
            files["plotjuggler_layout.xml"] = layout_file(self._tabs())
        return files

    def _tabs(self) -> List[LayoutTab]:
        told = {robot: self._heard[robot] for robot in self._topics if robot in self._heard}
        tabs = [LayoutTab(robot, tuple(_layout_overview(*s) for s in topics.items())) for robot, topics in told.items()]
        if sum(map(len, told.values())) <= _MOST_DETAILED:
            tabs += [
                LayoutTab(f"{robot} {task}", tuple(_layout_details(task, topic)))
                for robot, topics in told.items()
                for task, topic in topics.items()
            ]
        return tabs


def _overview(topic: str) -> RowPlot:
    return RowPlot(topic, "Motivation", topic, MOTIVATION_TYPE, _OVERVIEW)


def _details(robot: str, task: str, topic: str) -> List[RowPlot]:
    rows = [("motivation", _OVERVIEW), ("impatience", (PlotCurve("Impatience", "impatience"),))]
    rows += [(flag, (PlotCurve(flag.capitalize(), flag, limits=_FLAG_LIMITS),)) for flag in FLAGS]
    return [
        RowPlot(f"{robot}/alliance/{task}/{name}", name.capitalize(), topic, MOTIVATION_TYPE, curves, named=False)
        for name, curves in rows
    ]


def _layout_overview(task: str, topic: str) -> LayoutPlot:
    return LayoutPlot(task, tuple(LayoutCurve(f"{topic}/{curve.field}", curve.colour) for curve in _OVERVIEW))


def _layout_details(task: str, topic: str) -> List[LayoutPlot]:
    factors = ("impatience", *FLAGS)
    others = [LayoutPlot(name, (LayoutCurve(f"{topic}/{name}", _MOTIVATION.colour),)) for name in factors]
    return [_layout_overview(task, topic), *others]
