"""A stand-in for the drivers of a real builder: steppers, servo, magnet and SLAM, as rospy topics of one robot.

It speaks the topics of docs/applications/real_builder.md and no others, and knows nothing of the package that it
drives. Twists become wheel speeds and whole microsteps, and what was stepped becomes motion: Dantas (2017), equations
3.1 to 3.4 and 3.9, written out here once more. Nothing has mass; a block is pushed ahead by the magnet's face, held by
it, and falls when it is let go.
"""

from __future__ import annotations

import math
import threading
import time
from typing import Any, Dict, List, Optional, Tuple

__all__ = ["Builder", "Driver"]

_WHEEL, _HALF_LENGTHS = 0.04, 0.19
"""Radius of a wheel; half of the wheelbase and half of the track [m]."""
_STEP_ANGLE, _MICROSTEPS = 1.8, 16
"""Of the steppers [degrees], of their drivers."""
_ARM, _AHEAD, _HEIGHT = 0.22, 0.18, 0.15
"""Length of the arm; from the robot's middle to the magnet's face, and of the magnet above the floor, arm level [m]."""
_ARM_RATE = 0.5
_DEPTH, _RESTS = 0.07, 0.035
"""Of a block, and height of its middle on the floor [m]."""
_REACH_OF_MAGNET = 0.01
_WATCHDOG = 0.5
"""Without a new command for so long the wheels stand still [s]."""

_TICK = 0.02
"""Of the drivers [s]."""
_RATES = {"odom": 30.0, "pose": 1.0, "arm/state": 10.0, "magnet/state": 2.0}
"""How often they say what [Hz]."""

Place = Tuple[float, float, float]


def beyond(frame: Place, x: float, y: float, yaw: float = 0.0) -> Place:
    """Give what is seen from a place in the frame of that place."""
    cos, sin = math.cos(frame[2]), math.sin(frame[2])
    return frame[0] + cos * x - sin * y, frame[1] + sin * x + cos * y, frame[2] + yaw


def seen_from(frame: Place, place: Place) -> Place:
    """Give a place as seen from another one."""
    dx, dy, cos, sin = place[0] - frame[0], place[1] - frame[1], math.cos(frame[2]), math.sin(frame[2])
    return cos * dx + sin * dy, cos * dy - sin * dx, place[2] - frame[2]


class Builder:
    """The robot and one block.

    Attributes:
        start: where it began, frame ``map``.
        counted: where its wheels have brought it, from there.
        angle: of the arm [rad].
        block: middle of the block; its yaw is the heading of a robot that it lies square before.
        height: of the block's middle [m].
        held: whether the magnet holds it.
        dropped: from how high the block fell, each time it was let go [m].
        fastest: greatest speed and turn rate that were commanded [m/s, rad/s].
    """

    def __init__(self, start: Place, block: Place, half_length: float) -> None:
        self.start, self.counted = start, (0.0, 0.0, 0.0)
        self.angle = self.wanted_angle = math.pi / 2.0
        self.block, self.height, self.held = block, _RESTS, False
        self.magnet = False
        self.twist = (0.0, 0.0, 0.0)
        self.dropped: List[float] = []
        self.fastest = (0.0, 0.0)
        self._half_length = half_length
        self._grip = (0.0, 0.0, 0.0, 0.0)
        self._owed = [0.0] * 4

    @property
    def place(self) -> Place:
        """Where it is, frame ``map``."""
        return beyond(self.start, *self.counted)

    def command(self, vx: float, vy: float, wz: float) -> None:
        """Take a velocity of the base."""
        self.twist = (vx, vy, wz)
        self.fastest = max(self.fastest[0], math.hypot(vx, vy)), max(self.fastest[1], abs(wz))

    def step(self, elapsed: float) -> None:
        """Let so much time pass [s]."""
        self._drive(elapsed)
        way = self.wanted_angle - self.angle
        self.angle += math.copysign(min(abs(way), _ARM_RATE * elapsed), way)
        self._handle()

    def _drive(self, elapsed: float) -> None:
        vx, vy, wz = self.twist
        turn = _HALF_LENGTHS * wz
        speeds = [each / _WHEEL for each in (vx - vy - turn, vx + vy + turn, vx + vy - turn, vx - vy + turn)]
        per_radian = _MICROSTEPS * (360.0 / _STEP_ANGLE) / (2.0 * math.pi)
        rolled = []
        for wheel, speed in enumerate(speeds):
            self._owed[wheel] += speed * per_radian * elapsed
            steps = round(self._owed[wheel])
            self._owed[wheel] -= steps
            rolled.append(_WHEEL * steps / per_radian / 4.0)
        first, second, third, fourth = rolled
        turned = (-first + second - third + fourth) / _HALF_LENGTHS
        middle = beyond(self.counted, 0.0, 0.0, turned / 2.0)
        x, y, _ = beyond(middle, first + second + third + fourth, -first + second + third - fourth)
        self.counted = (x, y, self.counted[2] + turned)

    def _handle(self) -> None:
        face = beyond(self.place, _AHEAD + _ARM * math.cos(self.angle), 0.0)
        height = _HEIGHT + _ARM * math.sin(self.angle)
        if self.held and not self.magnet:
            self.held = False
            self.dropped.append(self.height - _RESTS)
            self.height = _RESTS
        if self.held:
            x, y, yaw, above = self._grip
            self.block, self.height = beyond(face, x, y, yaw), height + above
            return
        x, y, yaw = seen_from(face, self.block)
        gap, square = x - _DEPTH / 2.0, abs(math.remainder(yaw, 2.0 * math.pi)) < math.radians(10.0)
        beside = abs(y) > self._half_length or abs(height - self.height) > _DEPTH / 2.0
        if beside or not -_DEPTH < gap <= _REACH_OF_MAGNET:
            return
        if gap < 0.0:
            self.block = beyond(face, _DEPTH / 2.0, y, yaw)
            x = _DEPTH / 2.0
        if self.magnet and square:
            self.held, self._grip = True, (x, y, yaw, self.height - height)


class Driver:
    """Speaks for a builder on a ROS master, and for the clock; knows rospy, which must be imported in this process.

    Args:
        robot: id, and namespace of its topics.
        builder: the robot.
        factor: how many times as fast as the wall clock time goes.
    """

    def __init__(self, robot: str, builder: Builder, factor: float) -> None:
        import rospy
        from geometry_msgs.msg import PoseStamped, Twist
        from nav_msgs.msg import Odometry
        from rosgraph_msgs.msg import Clock
        from std_msgs.msg import Float64, String

        self.builder = builder
        self.now = 1000.0
        self.heard: Dict[str, int] = {}
        self._robot = robot
        self._factor = factor
        self._rospy = rospy
        self._lock = threading.Lock()
        self._commanded = -math.inf
        self._due: Dict[str, float] = {}
        self._told_held: Optional[bool] = None
        rospy.set_param("/use_sim_time", True)
        rospy.init_node("driver", disable_signals=True)
        self._clock = rospy.Publisher("/clock", Clock, queue_size=10)
        kinds = {"odom": Odometry, "pose": PoseStamped, "arm/state": Float64, "magnet/state": String}
        self._speakers = {
            topic: rospy.Publisher(f"/{robot}/{topic}", kind, queue_size=10) for topic, kind in kinds.items()
        }
        rospy.Subscriber(f"/{robot}/cmd_vel", Twist, self._hear_twist)
        rospy.Subscriber(f"/{robot}/arm/command", Float64, self._hear_arm)
        rospy.Subscriber(f"/{robot}/magnet/command", Float64, self._hear_magnet)
        threading.Thread(target=self._run, daemon=True).start()

    def _hear_twist(self, message: Any) -> None:
        with self._lock:
            self.heard["cmd_vel"] = self.heard.get("cmd_vel", 0) + 1
            self._commanded = self.now
            self.builder.command(message.linear.x, message.linear.y, message.angular.z)

    def _hear_arm(self, message: Any) -> None:
        with self._lock:
            self.heard["arm/command"] = self.heard.get("arm/command", 0) + 1
            self.builder.wanted_angle = message.data

    def _hear_magnet(self, message: Any) -> None:
        with self._lock:
            self.heard["magnet/command"] = self.heard.get("magnet/command", 0) + 1
            self.builder.magnet = message.data > 0.5

    def _run(self) -> None:
        begin, first = time.monotonic(), self.now
        while not self._rospy.is_shutdown():
            with self._lock:
                self.now += _TICK
                if self.now - self._commanded > _WATCHDOG:
                    self.builder.command(0.0, 0.0, 0.0)
                self.builder.step(_TICK)
                said = self._said()
            for topic, message in said:
                self._speakers[topic].publish(message)
            self._say_time()
            time.sleep(max(0.0, begin + (self.now - first) / self._factor - time.monotonic()))

    def _say_time(self) -> None:
        from rosgraph_msgs.msg import Clock

        self._clock.publish(Clock(self._rospy.Time.from_sec(self.now)))

    def _said(self) -> List[Tuple[str, Any]]:
        from std_msgs.msg import Float64, String

        said: List[Tuple[str, Any]] = []
        builder = self.builder
        for topic, rate in _RATES.items():
            changed = topic == "magnet/state" and builder.held != self._told_held
            if self.now < self._due.get(topic, 0.0) and not changed:
                continue
            self._due[topic] = self.now + 1.0 / rate - _TICK / 2.0
            if topic == "odom":
                said.append((topic, self._odometry()))
            elif topic == "pose":
                said.append((topic, self._localised()))
            elif topic == "arm/state":
                said.append((topic, Float64(builder.angle)))
            else:
                self._told_held = builder.held
                said.append((topic, String("block" if builder.held else "")))
        return said

    def _odometry(self) -> Any:
        from nav_msgs.msg import Odometry

        message = Odometry()
        message.header.stamp = self._rospy.Time.from_sec(self.now)
        message.header.frame_id, message.child_frame_id = f"{self._robot}/odom", f"{self._robot}/base_link"
        _write(message.pose.pose, self.builder.counted)
        return message

    def _localised(self) -> Any:
        from geometry_msgs.msg import PoseStamped

        message = PoseStamped()
        message.header.stamp = self._rospy.Time.from_sec(self.now)
        message.header.frame_id = "map"
        _write(message.pose, self.builder.place)
        return message


def _write(pose: Any, place: Place) -> None:
    pose.position.x, pose.position.y = place[:2]
    pose.orientation.z, pose.orientation.w = math.sin(place[2] / 2.0), math.cos(place[2] / 2.0)
