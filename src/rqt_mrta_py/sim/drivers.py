"""The drivers of a simulated team: what robots are commanded, looked at for all of them together."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, AbstractSet, Callable, Iterator, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Subscription, TeamHeard
from rqt_mrta_py.model import Twist
from rqt_mrta_py.sim.simulated_robot import SimulatedRobot

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["CMD_VEL", "COMMAND_TIMEOUT", "Drivers"]

CMD_VEL = Subscription("cmd_vel", "geometry_msgs/Twist", ("linear/x", "linear/y", "angular/z"))
"""What each robot hears in its own namespace."""

COMMAND_TIMEOUT = 0.5
"""A robot stands still once its newest command is older than this [s]."""

_TOO_OLD = COMMAND_TIMEOUT + 1e-6
"""From when on a command is too old, whatever rounding did to its age [s]."""


class Drivers:
    """Hears the commands of robots, and tells what they drive.

    Most robots go on in most ticks as they were commanded; a robot is asked what to drive only when something befell
    it, or when its newest command comes in or gets too old.

    Args:
        robots: by id.
        news: ids of those that something befell; robots enter themselves.
    """

    def __init__(self, robots: Mapping[str, SimulatedRobot], news: AbstractSet[str]) -> None:
        import numpy as np

        self._robots = tuple(robots.values())
        self._news = news
        self._rows = {robot_id: row for row, robot_id in enumerate(robots)}
        # When the newest command was heard, on the robot's clock [s].
        self._commanded_at = [-math.inf] * len(robots)
        self._obeying = np.zeros(len(robots), bool)
        self._driven: List[Optional[Twist]] = [None] * len(robots)

    def listener(self, robots: Sequence[str]) -> Tuple[Subscription, Callable[[TeamHeard], None]]:
        """Say what robots hear, each in its own namespace, and who is told of it.

        Args:
            robots: ids, in the order of the rows that will be told.
        """
        rows = [self._rows[robot_id] for robot_id in robots]
        all_robots, commanded_at = self._robots, self._commanded_at

        def hear(heard: TeamHeard) -> None:
            for row, receipt, fields in zip(map(rows.__getitem__, heard.rows), heard.receipts, heard.fields):
                commanded_at[row] = receipt
                robot = all_robots[row]
                if fields is not robot.newest:
                    robot.take(fields)

        return CMD_VEL, hear

    def commands(self, times: NDArray[np.float64]) -> Iterator[Tuple[str, Twist]]:
        """Tell who is to drive something else than before.

        Args:
            times: on each robot's clock [s], shape (robots,).

        Yields:
            Id and velocity, in the order of robots.
        """
        import numpy as np

        obeying = ~(times - np.array(self._commanded_at) > _TOO_OLD)
        rows = {self._rows[robot_id] for robot_id in self._news}
        rows.update(np.flatnonzero(obeying != self._obeying).tolist())
        self._obeying = obeying
        for row in sorted(rows):
            robot = self._robots[row]
            twist = robot.command(bool(obeying[row]))
            if twist is not self._driven[row]:
                self._driven[row] = twist
                yield robot.id, twist
