"""The load of the benchmark ``loop``: a team of any size, the same for each robot.

Each robot keeps one task of its own, says so once a second, and cruises at the control rate of 20 Hz, turning away from
what its range finder sees. It has a range finder of 36 rays and odometry at 10 Hz with transforms, and is located once
a second. There are walls around, and an obstacle for five robots, six at least.
"""

from __future__ import annotations

import math
from typing import Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import (
    AgentFactory,
    AgentSetup,
    BehaviourFactory,
    BehaviourSetup,
    BehaviourStep,
    Command,
    Decision,
    Heard,
    Outgoing,
    Perception,
    Situation,
    Subscription,
    hookimpl,
)
from rqt_mrta_py.model import (
    ApplicationRobot,
    ApplicationSpec,
    ArchitectureSpec,
    Arena,
    Mission,
    MonitoredTopic,
    Obstacle,
    Pose,
    RobotSetup,
    ScenarioSpec,
    SensorSetup,
    Task,
    Taxonomy,
    Twist,
)

__all__ = ["CONTROL_RATE", "LoadPlugin", "load_mission_of"]

CONTROL_RATE = 20
_SPACING = 2.0
"""Between the starts of neighbours [m]."""
_ARCHITECTURE = "bench_load"
_KIND = "bench_cruise"
_SCAN = Subscription("scan", "sensor_msgs/LaserScan", ("ranges",))
_SENSORS = (
    SensorSetup("localiser", "pose", 1.0),
    SensorSetup("odometry", "odom", 10.0),
    SensorSetup("range_finder", "scan", 10.0, {"rays": 36, "max_range": 4.0}),
)
_HOLDING = MonitoredTopic("/@robot_id@/holding/@task_id@", "std_msgs/String", timeout=2.5)


def load_mission_of(robots: int, world: str, duration: float) -> Mission:
    """Make the mission of a benchmark.

    Args:
        robots: how many.
        world: where to simulate.
        duration: of the mission [s].
    """
    columns = math.ceil(math.sqrt(robots))
    half = columns * _SPACING / 2
    ids = [f"robot{number + 1}" for number in range(robots)]
    tasks = tuple(Task(f"cruise{number + 1}", _KIND, perpetual=True) for number in range(robots))
    starts = [
        Pose(_SPACING * (n % columns) + 1.0 - half, _SPACING * (n // columns) + 1.0 - half, (2.4 * n) % 6.0 - 3.0)
        for n in range(robots)
    ]
    scenario = ScenarioSpec(
        arena=Arena(-half, -half, half, half),
        obstacles=_obstacles(columns, max(6, robots // 5)),
        robots=tuple(RobotSetup(i, "diff_drive", start, _SENSORS) for i, start in zip(ids, starts)),
        world=world,
        duration=duration,
        control_rate=CONTROL_RATE,
    )
    members = tuple(ApplicationRobot(robot_id, (task.id,)) for robot_id, task in zip(ids, tasks))
    return Mission(
        application=ApplicationSpec("bench_loop", f"{robots} robots", robots=members),
        architecture=ArchitectureSpec(_ARCHITECTURE, "Fixed load", Taxonomy.parse("ST-SR-IA"), busy_robots=(_HOLDING,)),
        tasks=tasks,
        scenario=scenario,
        seed=0,
    )


def _obstacles(columns: int, number: int) -> Tuple[Obstacle, ...]:
    """Put boxes where the corners of four robots' squares meet, as evenly as there is room."""
    corners = [(x, y) for y in range(1, columns) for x in range(1, columns)]
    step = max(1, len(corners) // number)
    half = columns * _SPACING / 2
    return tuple(
        Obstacle(f"box{index + 1}", Pose(_SPACING * x - half, _SPACING * y - half, 0.4), (0.5, 0.4, 0.4))
        for index, (x, y) in enumerate(corners[::step][:number])
    )


class _Keeper:
    """Keeps its task and says so."""

    rate = 1.0

    def __init__(self, setup: AgentSetup) -> None:
        (self._task,) = (task.id for task in setup.tasks)

    def subscriptions(self) -> Sequence[Subscription]:
        """Say that it hears nobody."""
        return ()

    def step(self, situation: Situation) -> Decision:
        """Go on."""
        return Decision(self._task, (Outgoing(f"holding/{self._task}", "std_msgs/String", {"data": self._task}),))


class _Cruise:
    """Drives on, and turns while something is near ahead."""

    def __init__(self, setup: BehaviourSetup) -> None:
        speed, turn_rate = setup.model.max_speed, setup.model.max_turn_rate
        self._on = BehaviourStep((Command("base", Twist(0.8 * speed, 0.0, 0.0)),))
        self._left = BehaviourStep((Command("base", Twist(0.2 * speed, 0.0, 0.5 * turn_rate)),))
        self._right = BehaviourStep((Command("base", Twist(0.2 * speed, 0.0, -0.5 * turn_rate)),))
        self._seen: Optional[Heard] = None
        self._step = self._on

    def subscriptions(self) -> Sequence[Subscription]:
        """Hear the range finder."""
        return (_SCAN,)

    def applicable(self, task: Task, perception: Perception) -> bool:
        """Say that it always is."""
        return True

    def cost(self, task: Task, perception: Perception) -> Optional[float]:
        """Say that it costs nothing."""
        return 0.0

    def start(self, task: Task, perception: Perception) -> None:
        """Begin."""

    def step(self, task: Task, perception: Perception) -> BehaviourStep:
        """Look ahead when the range finder told something new: rays go from -pi on, 10 degrees apart."""
        scan = perception.newest("scan")
        if scan is not None and scan is not self._seen:
            self._seen = scan
            self._step = self._towards_room(scan.fields["ranges"])
        return self._step

    def _towards_room(self, ranges: Sequence[float]) -> BehaviourStep:
        right, left = min(ranges[13:18]), min(ranges[18:23])
        if min(right, left) > 0.7:
            return self._on
        return self._left if left >= right else self._right


class LoadPlugin:
    """Registers what the load needs, for a benchmark's own plugin manager."""

    @hookimpl
    def mrta_register_agents(self) -> Mapping[str, AgentFactory]:
        """Name the agent."""
        return {_ARCHITECTURE: _Keeper}

    @hookimpl
    def mrta_register_behaviours(self) -> Mapping[str, BehaviourFactory]:
        """Name the behaviour."""
        return {_KIND: _Cruise}
