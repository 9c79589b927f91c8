"""One robot's share of an architecture: an object that does no I/O.

It is told the time, what it heard and how its current task goes, and answers what to say and which task to carry
out. It opens no socket, reads no clock, draws no random number that it was not handed; so the same object runs by
the hundred in one simulated process, or alone in a ROS node on a robot.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, Protocol, Sequence, Tuple

from rqt_mrta_py.hooks.allocator import Allocator
from rqt_mrta_py.hooks.evaluator import SensoryEvaluatorFactory
from rqt_mrta_py.hooks.robot_sensor import RobotSensorFactory
from rqt_mrta_py.hooks.stream import AnyOutgoing, Heard, Subscription
from rqt_mrta_py.model import Pose, Progress, Task

if TYPE_CHECKING:
    import numpy as np

__all__ = ["Agent", "AgentFactory", "AgentSetup", "Decision", "Situation", "TaskReport"]


@dataclass(frozen=True)
class AgentSetup:
    """What an agent is made from.

    Attributes:
        robot_id: normalised; the agent's namespace is ``/<robot_id>``.
        team: ids of all robots of the application, in its order, this one included.
        tasks: the tasks this robot may carry out, in the mission's order.
        parameters: this robot's, nested as in its YAML file, complete and checked against the templates.
        random: this robot's own generator.
        evaluators: sensory evaluators by name (``package/name``).
        allocators: by name (``package/name``).
        later_tasks: that this robot may carry out once they appear: not there yet, not applicable until then.
        sensors: readers of the robot's own sensors by name (``package/name``).
    """

    robot_id: str
    team: Tuple[str, ...]
    tasks: Tuple[Task, ...]
    parameters: Mapping[str, Any]
    random: np.random.Generator
    evaluators: Mapping[str, SensoryEvaluatorFactory] = field(default_factory=dict)
    allocators: Mapping[str, Allocator] = field(default_factory=dict)
    later_tasks: Tuple[Task, ...] = ()
    sensors: Mapping[str, RobotSensorFactory] = field(default_factory=dict)


@dataclass(frozen=True)
class TaskReport:
    """How a task goes, or what an operator wants of it.

    Attributes:
        task: its id.
        progress: what was reported.
        detail: why, in a few words.
        robot: who reports it; of REASSIGNED the robot that it shall go to; None for an operator otherwise.
        definition: of a task that appeared, what it is, where the message says so.
    """

    task: str
    progress: Progress
    detail: str = ""
    robot: Optional[str] = None
    definition: Optional[Task] = None


@dataclass(frozen=True)
class Situation:
    """What an agent is told at one step of its cycle.

    Attributes:
        now: the time [s].
        heard: what came since the step before, in order of receipt.
        reports: what became of tasks since the step before: this robot's own, and what operators want.
        applicable: by task id, whether the robot's behaviour for it could be carried out now; never changed, so the
            same object may be given again.
        cost: from a task's id to what it would cost this robot now; None if it cannot tell.
        pose: where the robot believes to be, in the frame ``map``; None if it does not know.
    """

    now: float
    heard: Sequence[Heard]
    reports: Sequence[TaskReport]
    applicable: Mapping[str, bool]
    cost: Callable[[str], Optional[float]]
    pose: Optional[Pose] = None


@dataclass(frozen=True)
class Decision:
    """What an agent answers.

    Attributes:
        task: id of the task to carry out from now on; None to do nothing.
        messages: what to say, in this order; many of one type together, where there are many.
    """

    task: Optional[str]
    messages: Sequence[AnyOutgoing] = ()


class Agent(Protocol):
    """One robot's share of an architecture."""

    @property
    def rate(self) -> float:
        """How often a second ``step`` shall be called [Hz]."""
        ...

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear; asked once, before the first step. Relative names stand in the robot's namespace."""
        ...

    def step(self, situation: Situation) -> Decision:
        """Take in what happened and decide; called with strictly increasing times, not at all while stopped."""
        ...


AgentFactory = Callable[[AgentSetup], Agent]
