"""Behaviours: how one kind of task is carried out, whatever the architecture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable, Optional, Protocol, Sequence, Tuple, Union

from rqt_mrta_py.hooks.navigator import Navigator
from rqt_mrta_py.hooks.robot_model import RobotModel
from rqt_mrta_py.hooks.stream import Heard, Outgoing, Subscription
from rqt_mrta_py.model import Pose, Progress, Task, Twist

if TYPE_CHECKING:
    import numpy as np

__all__ = ["Behaviour", "BehaviourFactory", "BehaviourSetup", "BehaviourStep", "Command", "Perception"]


class Perception(Protocol):
    """What a robot has heard so far, newest message by topic."""

    @property
    def now(self) -> float:
        """The time [s]."""
        ...

    @property
    def pose(self) -> Optional[Pose]:
        """Where the robot believes to be, in the frame ``map``; None if it does not know yet."""
        ...

    def newest(self, topic: str) -> Optional[Heard]:
        """Give the newest message of a topic that was subscribed to, by the name used there; None before the first."""
        ...


@dataclass(frozen=True)
class BehaviourSetup:
    """What a behaviour is made from.

    Attributes:
        robot_id: normalised.
        model: what the robot is like.
        navigator: finds ways on the map known to the robot.
        random: this robot's own generator.
        map_revision: counts how often the map that the navigator plans on has changed, up to now; None: it is known
            from the start and stays.
        team: ids of all robots of the application, in its order, this one included.
        tasks: those of any kind that this robot may carry out, present and later ones, in the mission's order.
    """

    robot_id: str
    model: RobotModel
    navigator: Navigator
    random: np.random.Generator
    map_revision: Optional[Callable[[], int]] = None
    team: Tuple[str, ...] = ()
    tasks: Tuple[Task, ...] = ()


@dataclass(frozen=True)
class Command:
    """A command to one actuator; a base takes a Twist, anything else a number in the actuator's own unit."""

    actuator: str
    value: Union[Twist, float]


@dataclass(frozen=True)
class BehaviourStep:
    """What a behaviour answers.

    Attributes:
        commands: to the robot's actuators, at most one for each; an actuator left out stands still.
        progress: RUNNING, DONE, FAILED or UNREACHABLE.
        detail: why, in a few words, where the progress is not RUNNING.
        messages: what to say.
    """

    commands: Sequence[Command] = ()
    progress: Progress = Progress.RUNNING
    detail: str = ""
    messages: Sequence[Outgoing] = ()


class Behaviour(Protocol):
    """Carries out tasks of one kind for one robot."""

    def subscriptions(self) -> Sequence[Subscription]:
        """Say what to hear; asked once. Relative names stand in the robot's namespace."""
        ...

    def applicable(self, task: Task, perception: Perception) -> bool:
        """Tell whether the task could be carried out now; must not change anything."""
        ...

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        """Estimate what is left to do [m of travel, or seconds where nothing moves]; None if it cannot tell."""
        ...

    def start(self, task: Task, perception: Perception) -> None:
        """Begin, or begin again, with a task; called before its first step."""
        ...

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        """Carry out one control tick."""
        ...


BehaviourFactory = Callable[[BehaviourSetup], Behaviour]
