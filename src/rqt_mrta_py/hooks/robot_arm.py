"""Arms with one joint, whose wrist keeps the electromagnet level.

D. de O. Dantas, *Implementação de um Sistema Autônomo de Construção de Estrutura usando Aprendizado por Reforço*,
Universidade Federal do Maranhão, 2017 (Dantas 2017), section 3.3.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

from rqt_mrta_py.model import Pose

__all__ = ["ArmModel"]

_EXACT = 1e-9
"""An angle that was a height before is as exact [rad]."""


@dataclass(frozen=True)
class ArmModel:
    """An arm that moves in the vertical plane straight ahead of its robot.

    Attributes:
        length: from joint 1 to joint 2, L_a [m].
        joint_ahead: from the robot's centre to joint 1, L_x1 [m].
        magnet_ahead: from joint 2 to the magnet's face, L_x2 [m].
        joint_height: of joint 1 above the floor, L_z1 [m].
        magnet_below: from the magnet's centre up to joint 2, L_z2 [m].
        lowest, highest: angles that joint 1 reaches, 0 straight ahead, above 0 upwards [rad].
        rate: of joint 1 [rad/s].
        grip_gap: the magnet holds what its face is at most so far from [m].
        max_force: of the magnet; a stronger pull tears off what it holds [N].

    Raises:
        ValueError: a measure is not finite, a length, rate, gap or force is not above 0, or ``lowest`` is not below
            ``highest``, both within a quarter turn; names it.
    """

    length: float
    joint_ahead: float
    magnet_ahead: float
    joint_height: float
    magnet_below: float
    lowest: float
    highest: float
    rate: float
    grip_gap: float = 0.01
    max_force: float = 30.0

    def __post_init__(self) -> None:
        for each in fields(self):
            value: object = getattr(self, each.name)
            if not isinstance(value, (int, float)) or not math.isfinite(value):
                raise ValueError(f"arm: {each.name} must be a finite number (got {value!r})")
        for name in ("length", "joint_height", "rate", "grip_gap", "max_force"):
            if getattr(self, name) <= 0.0:
                raise ValueError(f"arm: {name} must be above 0 (got {getattr(self, name)!r})")
        if not -math.pi / 2.0 <= self.lowest < self.highest <= math.pi / 2.0:
            raise ValueError(
                f"arm: lowest {self.lowest!r} must be below highest {self.highest!r}, both within a quarter turn"
            )

    def angle_at(self, height: float) -> float:
        """Give the angle of joint 1 that brings the magnet to a height.

        theta_1 = asin((z_e - L_z1 + L_z2) / L_a)

        Dantas (2017), equation 3.5.

        Args:
            height: of the magnet's centre above the floor, z_e [m].

        Returns:
            theta_1 [rad].

        Raises:
            ValueError: the arm does not reach so low or so high; says what it reaches.
        """
        sine = (height - self.joint_height + self.magnet_below) / self.length
        if abs(sine) <= 1.0:
            angle = math.asin(sine)
            if self.lowest - _EXACT <= angle <= self.highest + _EXACT:
                return angle
        lowest, highest = self.height_at(self.lowest), self.height_at(self.highest)
        raise ValueError(f"the arm does not reach {height:.3f} m; it reaches {lowest:.3f} to {highest:.3f} m")

    def height_at(self, angle: float) -> float:
        """Give the height of the magnet's centre above the floor [m]: equation 3.5, solved for z_e.

        Args:
            angle: of joint 1, theta_1 [rad].
        """
        return self.joint_height - self.magnet_below + self.length * math.sin(angle)

    def reach_at(self, angle: float) -> float:
        """Give how far ahead of the robot's centre the magnet's face is: L_a cos(theta_1) + L_x1 + L_x2 [m].

        Args:
            angle: of joint 1, theta_1 [rad].
        """
        return self.length * math.cos(angle) + self.joint_ahead + self.magnet_ahead

    def base_pose(self, magnet: Pose, angle: float) -> Pose:
        """Give where the robot must stand so that its magnet's face is at a pose.

        x_r = x_e - (L_a cos(theta_1) + L_x1 + L_x2) cos(theta_g), y_r alike with the sine, theta_r = theta_e

        Dantas (2017), equations 3.6 to 3.8.
        Differs from the paper: it leaves out the brackets, so that only L_x2 would be turned by the heading.

        Args:
            magnet: of the magnet's face; its yaw is the robot's heading, frame ``map``.
            angle: of joint 1 when the magnet is there, theta_1 [rad].
        """
        reach = self.reach_at(angle)
        return Pose(magnet.x - reach * math.cos(magnet.yaw), magnet.y - reach * math.sin(magnet.yaw), magnet.yaw)

    def magnet_pose(self, base: Pose, angle: float) -> Pose:
        """Give where the magnet's face is, seen from above: the reverse of ``base_pose``.

        Args:
            base: of the robot, frame ``map``.
            angle: of joint 1, theta_1 [rad].
        """
        reach = self.reach_at(angle)
        return Pose(base.x + reach * math.cos(base.yaw), base.y + reach * math.sin(base.yaw), base.yaw)
