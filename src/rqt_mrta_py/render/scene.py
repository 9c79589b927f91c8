"""Follows the stream to know where everything is."""

from __future__ import annotations

import math
from typing import Callable, Dict, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.config.tasks.task_text import read_task
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.hooks import Heard, RobotModel, RobotSight, SceneView, Subscription
from rqt_mrta_py.model import Mission, Pose, Progress, Task, normalise_id
from rqt_mrta_py.render.body_keeper import BodyKeeper, BodyTrack
from rqt_mrta_py.render.frames import FrameTree
from rqt_mrta_py.render.happenings import LabelKeeper
from rqt_mrta_py.render.path import PathKeeper
from rqt_mrta_py.render.pose_log import PoseLog, RobotTrack

__all__ = ["DEFAULT_RADIUS", "SceneTracker"]

DEFAULT_RADIUS = 0.2
"""Radius drawn for a robot of unknown model [m]."""

_FRAME, _X, _Y = "header/frame_id", "pose/position/x", "pose/position/y"
_QX, _QY, _QZ, _QW = (f"pose/orientation/{axis}" for axis in "xyzw")
_POSES = Subscription("/@robot_id@/pose", "geometry_msgs/PoseStamped", (_FRAME, _X, _Y, _QX, _QY, _QZ, _QW))
_TRANSFORMS = tuple(Subscription(topic, "tf2_msgs/TFMessage", ("transforms",)) for topic in ("/tf", "/tf_static"))
_PROGRESS = Subscription("/mrta/task_progress", "rqt_mrta_py/TaskProgress", ("task_id", "progress", "task_yaml"))

# Trails and paths of all robots together have about so many points at most; a trail has no fewer than the last.
_TRAIL_POINTS, _PATH_POINTS, _FEWEST = 4000, 400_000, 5
_SPACING, _FEW_ROBOTS = 0.05, 40

# What the report shows of any moment: so often a pose [s]; about so many of all robots together, of one robot from so
# many to so many.
_LOG_PERIOD, _LOG_POSES, _FEWEST_LOGGED, _MOST_LOGGED = 0.2, 400_000, 60, 20_000


class SceneTracker:
    """Knows the arena, and from the stream where robots and bodies are, which tasks there are, what was made happen.

    A Listener. Robots of the mission come first, in its order, then any other that tells its pose, by first sight. A
    robot that never tells a pose is placed by its transforms. Poses in another frame than ``map``, or not finite, are
    passed over. The larger the team, the coarser trails and paths: their points are bounded for all robots together.

    Args:
        mission: whose scenario, if any, tells arena, obstacles and the robots' models.
        models: kinds of robots by name, for their size.
        trail: how far back trails reach [s].
    """

    def __init__(self, mission: Mission, models: Mapping[str, RobotModel], trail: float = 60.0) -> None:
        scenario = mission.scenario
        robots = [robot.id for robot in mission.application.robots]
        self._arena = scenario.arena if scenario else None
        self._obstacles = scenario.obstacles if scenario else ()
        self._known_tasks = {task.id: task for task in mission.every_task}
        self._tasks: Dict[str, Task] = {task.id: task for task in mission.tasks}
        self._models = models
        self._model_of = {robot.id: robot.model for robot in scenario.robots} if scenario else {}
        self._trail = trail
        self._team = max(len(robots), 1)
        self._tracks: Dict[str, _Track] = {robot: self._new_track(robot) for robot in robots}
        self._frames = FrameTree(robots[0] if len(robots) == 1 else None)
        self._transforms_matter = scenario is None or not all(
            any(normalise_id(sensor.topic) == "pose" for sensor in robot.sensors) for robot in scenario.robots
        )
        self._labels = LabelKeeper()
        self._bodies = BodyKeeper(scenario)
        # What the newest view shows of the robots, while nothing newer is heard of them.
        self._sights: Optional[Tuple[RobotSight, ...]] = None
        self._seen_at = self._oldest = 0.0
        self._ears: Dict[str, Callable[[Heard], None]] = {
            _POSES.type: self._hear_pose,
            _TRANSFORMS[0].type: self._hear_transforms,
            _PROGRESS.type: self._hear_progress,
            LabelKeeper.SUBSCRIPTION.type: self._hear_label,
            BodyKeeper.SUBSCRIPTION.type: self._bodies.hear,
        }

    def subscriptions(self) -> Sequence[Subscription]:
        """Ask for poses, progress, scenario events, bodies; for transforms unless all simulated robots tell poses."""
        transforms = _TRANSFORMS if self._transforms_matter else ()
        return (_POSES, _PROGRESS, LabelKeeper.SUBSCRIPTION, BodyKeeper.SUBSCRIPTION, *transforms)

    def hear(self, heard: Heard) -> None:
        """Take in one message.

        Args:
            heard: a message subscribed to.
        """
        self._ears[heard.type](heard)

    def view(self, now: float, whole: bool = False) -> SceneView:
        """Give the scene at a moment.

        Args:
            now: the moment, not before the newest message heard [s].
            whole: give whole paths, thinned, rather than the trails of the last seconds.
        """
        robots = tuple([track.whole_sight() for track in self._tracks.values()]) if whole else self._seen(now)
        tasks, bodies = tuple(self._tasks.values()), self._bodies.bodies()
        return SceneView(self._arena, self._obstacles, robots, tasks, self._labels.labels(), bodies)

    def tracks(self) -> Tuple[RobotTrack, ...]:
        """Give where each robot was at which moment, as finely as it was kept."""
        removed = self._labels.removed
        return tuple(
            track.log.track(robot, track.radius)._replace(gone=removed.get(robot))
            for robot, track in self._tracks.items()
        )

    def body_tracks(self) -> Tuple[BodyTrack, ...]:
        """Give where each loose body was at which moment, sorted by id."""
        return self._bodies.tracks()

    def every_task(self) -> Tuple[Task, ...]:
        """Give every task that was known at any moment: those listed first, in their order."""
        return tuple({**self._known_tasks, **self._tasks}.values())

    def _seen(self, now: float) -> Tuple[RobotSight, ...]:
        """Give the robots with their recent trails; the same again until one is heard or a trail grows too old."""
        if self._sights is None or now < self._seen_at or self._oldest < now - self._trail:
            sights = self._sights = tuple([track.sight(now) for track in self._tracks.values()])
            self._seen_at = now
            self._oldest = min((sight.trail[0][0] for sight in sights if len(sight.trail) > 1), default=math.inf)
        return self._sights

    def _hear_pose(self, heard: Heard) -> None:
        fields = heard.fields
        frame, x, y = fields[_FRAME], fields[_X], fields[_Y]
        qx, qy, qz, qw = turn = (fields[_QX], fields[_QY], fields[_QZ], fields[_QW])
        # A sum is finite only if each of its parts is.
        if frame not in {"map", "/map"} or not math.isfinite(x + y + qx + qy + qz + qw):
            return
        track = self._tracks.get(heard.robot) or self._track(heard.robot)
        self._sights = None
        track.turn = turn
        track.located = True
        track.path.add(heard.receipt, x, y)
        if heard.receipt >= track.log.due:
            track.log.add(heard.receipt, x, y, turn)

    def _hear_transforms(self, heard: Heard) -> None:
        for robot, pose in self._frames.take(heard.fields["transforms"]):
            track = self._track(robot)
            if not track.located:
                self._sights = None
                track.turn = (0.0, 0.0, math.sin(pose.yaw / 2.0), math.cos(pose.yaw / 2.0))
                track.path.add(heard.receipt, pose.x, pose.y)
                if heard.receipt >= track.log.due:
                    track.log.add(heard.receipt, pose.x, pose.y, track.turn)

    def _hear_label(self, heard: Heard) -> None:
        self._labels.hear(heard)
        for robot in self._labels.removed.keys() & self._tracks.keys():
            self._tracks[robot].is_gone = True
            self._sights = None

    def _hear_progress(self, heard: Heard) -> None:
        code, task = heard.fields["progress"], normalise_id(heard.fields["task_id"])
        progress = Progress.of_code(code)
        if progress is Progress.WITHDRAWN:
            self._tasks.pop(task, None)
        elif progress is Progress.APPEARED:
            definition = _definition(heard.fields["task_yaml"], task) or self._known_tasks.get(task)
            if definition is not None and self._tasks.get(task) != definition:
                self._tasks.pop(task, None)
                self._tasks[task] = definition

    def _track(self, robot: str) -> _Track:
        robot = normalise_id(robot)
        if robot not in self._tracks:
            self._tracks[robot] = self._new_track(robot)
        return self._tracks[robot]

    def _new_track(self, robot: str) -> _Track:
        team = self._team
        path = PathKeeper(
            self._trail,
            spacing=_SPACING * max(1.0, math.sqrt(team / _FEW_ROBOTS)),
            most=max(min(_TRAIL_POINTS // team, 400), _FEWEST),
            longest=max(min(_PATH_POINTS // team, 4000), _FEWEST),
        )
        model = self._models.get(self._model_of.get(robot, ""))
        log = PoseLog(
            _LOG_PERIOD * max(1.0, math.sqrt(team / _FEW_ROBOTS)),
            max(min(_LOG_POSES // team, _MOST_LOGGED), _FEWEST_LOGGED),
        )
        return _Track(robot, path, log, DEFAULT_RADIUS if model is None else model.radius)


class _Track:
    """One robot.

    Its path, poses, newest orientation as x, y, z, w, whether it ever told a pose, its radius [m], whether it is gone.
    """

    __slots__ = ("_robot", "_seen", "_seen_at", "_sight", "is_gone", "located", "log", "path", "radius", "turn")

    def __init__(self, robot: str, path: PathKeeper, log: PoseLog, radius: float) -> None:
        self._robot = robot
        self.path = path
        self.log = log
        self.radius = radius
        self.turn = (0.0, 0.0, 0.0, 1.0)
        self.located = False
        self.is_gone = False
        self._sight: Optional[RobotSight] = None
        self._seen: Optional[Tuple[float, float, float]] = None
        self._seen_at = 0.0

    def sight(self, now: float) -> RobotSight:
        """Give the robot with its recent trail; the same object until it is heard again or the trail grows old."""
        if self.is_gone:
            return RobotSight(self._robot, None, self.radius)
        sight, path = self._sight, self.path
        if sight is None or path.newest is not self._seen or now < self._seen_at or path.fades(sight.trail, now):
            sight = self._sight = RobotSight(self._robot, self._pose(), self.radius, path.recent(now))
            self._seen, self._seen_at = path.newest, now
        return sight

    def whole_sight(self) -> RobotSight:
        """Give the robot with its whole path."""
        return RobotSight(self._robot, self._pose(), self.radius, self.path.whole())

    def _pose(self) -> Optional[Pose]:
        if self.path.newest is None or self.is_gone:
            return None
        _, x, y = self.path.newest
        qx, qy, qz, qw = self.turn
        return Pose(x, y, math.atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz)))


def _definition(text: str, task: str) -> Optional[Task]:
    """Read what a task is from a message, which anybody may have written; None if it makes no sense."""
    if not text:
        return None
    try:
        definition = read_task(text, "task_yaml")
    except ConfigError:
        return None
    return definition if definition.id == task else None
