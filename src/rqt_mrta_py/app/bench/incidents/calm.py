"""A mission in which nothing happened, as its record tells: where a fault could strike."""

from __future__ import annotations

from typing import List, NamedTuple, Tuple

from rqt_mrta_py.app.bench.incidents.setting import Setting
from rqt_mrta_py.hooks import AllocationPace, Experiment
from rqt_mrta_py.model import Allocation, Mission, MissionRecord, MonitoredTopic, Outcome

__all__ = ["CalmMission"]


class CalmMission(NamedTuple):
    """A mission in which nothing happened.

    Up to the moment at which a fault strikes, a mission with the fault is this one to the byte. All times are stamps:
    mission second s carries stamp s + 1.

    Attributes:
        setting: that it is made of.
        experiment: that was carried out.
        mission: that the experiment means.
        pace: of its architecture.
        record: what came of it.
    """

    setting: Setting
    experiment: Experiment
    mission: Mission
    pace: AllocationPace
    record: MissionRecord

    @property
    def end(self) -> float:
        """Until when it may last [s]."""
        return 1.0 + (self.experiment.duration or 0.0)

    @property
    def robots(self) -> Tuple[str, ...]:
        """Ids of the team, in the application's order."""
        return tuple(robot.id for robot in self.mission.application.robots)

    @property
    def claim(self) -> MonitoredTopic:
        """The topic on which robots say what they carry out."""
        return self.mission.architecture.busy_robots[0]

    @property
    def idle_topic(self) -> MonitoredTopic:
        """The topic on which robots say that they are there."""
        return self.mission.architecture.idle_robots[0]

    @property
    def tolerance(self) -> float:
        """How far a robot's clock may be off, on any monitored topic [s]: half the timeout, at least 0.5 s."""
        return max(0.5, max(topic.timeout for topic in self.mission.architecture.monitored_topics) / 2.0)

    def can(self, robot: str, task: str) -> bool:
        """Tell whether a robot is given a task."""
        return any(each.id == task for each in self.mission.tasks_of(robot))

    def holds(self, start: float, end: float) -> List[Allocation]:
        """List what is held all the while from one time to another [s], by robot."""
        return sorted(
            (each for each in self.record.allocations if each.start <= start and each.end >= end),
            key=lambda each: (each.robot, each.task),
        )

    def idle(self, start: float, end: float) -> List[str]:
        """List the robots that hold nothing from one time to another [s], in the application's order."""
        working = {each.robot for each in self.record.allocations if each.start <= end and each.end >= start}
        return [robot for robot in self.robots if robot not in working]

    def done(self, start: float, end: float) -> List[Allocation]:
        """List what is done between two times [s], by robot and task."""
        return sorted(
            (each for each in self.record.allocations if each.outcome is Outcome.DONE and start <= each.end <= end),
            key=lambda each: (each.robot, each.task),
        )
