"""Mecanum wheels: what a base's twist means for its four wheels, and the other way round.

Wheels are front left, front right, rear left, rear right; x points forward, y to the left.

D. de O. Dantas, *Implementação de um Sistema Autônomo de Construção de Estrutura usando Aprendizado por Reforço*,
Universidade Federal do Maranhão, 2017 (Dantas 2017), sections 3.1 and 3.2.
"""

from __future__ import annotations

from typing import NamedTuple, Tuple

from rqt_mrta_py.model import Twist

__all__ = ["MecanumWheels", "pulse_frequency", "step_rate", "within_wheel_speed"]

Speeds = Tuple[float, float, float, float]


class MecanumWheels(NamedTuple):
    """Four mecanum wheels at the corners of a rectangle.

    Attributes:
        radius: of a wheel, r [m].
        half_lengths: half of the distance between axles and half of that between the wheels of one, s = l_x + l_y [m].
    """

    radius: float
    half_lengths: float

    def speeds(self, twist: Twist) -> Speeds:
        """Give how fast the wheels turn [rad/s].

        w_1 = (vx - vy - s wz) / r    w_2 = (vx + vy + s wz) / r
        w_3 = (vx + vy - s wz) / r    w_4 = (vx - vy + s wz) / r

        Dantas (2017), equations 3.1 and 3.2.

        Args:
            twist: of the base.
        """
        turn = self.half_lengths * twist.wz
        return (
            (twist.vx - twist.vy - turn) / self.radius,
            (twist.vx + twist.vy + turn) / self.radius,
            (twist.vx + twist.vy - turn) / self.radius,
            (twist.vx - twist.vy + turn) / self.radius,
        )

    def twist(self, speeds: Speeds) -> Twist:
        """Give the twist of the base of turning wheels.

        vx = r/4 (w_1 + w_2 + w_3 + w_4)    vy = r/4 (-w_1 + w_2 + w_3 - w_4)    wz = r/(4s) (-w_1 + w_2 - w_3 + w_4)

        Dantas (2017), equations 3.3 and 3.4.

        Args:
            speeds: of the wheels [rad/s].
        """
        first, second, third, fourth = speeds
        quarter = self.radius / 4.0
        return Twist(
            quarter * (first + second + third + fourth),
            quarter * (-first + second + third - fourth),
            quarter / self.half_lengths * (-first + second - third + fourth),
        )


def within_wheel_speed(wheels: MecanumWheels, twist: Twist, most: float) -> Twist:
    """Slow a twist down, its direction kept, until no wheel turns too fast.

    Args:
        wheels: of the base.
        twist: that is wanted.
        most: of a wheel [rad/s].
    """
    fastest = max(map(abs, wheels.speeds(twist)))
    if fastest <= most:
        return twist
    share = most / fastest
    return Twist(twist.vx * share, twist.vy * share, twist.wz * share)


def step_rate(speed: float, step_angle: float, microsteps: int) -> float:
    """Give how many steps a second the stepper of a wheel makes.

    n = w m_p (360 / rho) / (2 pi), with rho in degrees; in radians, w m_p / rho.

    Dantas (2017), equation 3.9.

    Args:
        speed: of the wheel, w; below 0 backwards [rad/s].
        step_angle: that a whole step turns it by, rho; of the source's motors 0.9 or 1.8 degrees [rad].
        microsteps: that a whole step is divided into, m_p.

    Returns:
        Steps a second, below 0 backwards [1/s].

    Raises:
        ValueError: the angle is not above 0, or there is not one microstep.
    """
    if not step_angle > 0.0 or microsteps < 1:
        raise ValueError(f"a stepper has a step angle above 0 and microsteps (got {step_angle!r}, {microsteps!r})")
    return speed * microsteps / step_angle


def pulse_frequency(rate: float) -> float:
    """Give the frequency at which the line of a stepper's driver changes: f = 2 n, each step up and down again [Hz].

    Dantas (2017), equation 3.10.

    Args:
        rate: n, steps a second in either direction [1/s].
    """
    return 2.0 * abs(rate)
