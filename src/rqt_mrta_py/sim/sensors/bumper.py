"""A bumper: feels that its robot touches something."""

from __future__ import annotations

from typing import Sequence

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Outgoing, SensorContext, SensorMoment
from rqt_mrta_py.sim.sensing.mount import where_it_is
from rqt_mrta_py.sim.sensors.settings import SensorSettings

__all__ = ["Bumper"]


class Bumper:
    """Publishes std_msgs/Bool: whether the robot touches a wall, an obstacle, a loose body or another robot.

    It has no parameters. Its world must know contacts.
    """

    def __init__(self, context: SensorContext) -> None:
        SensorSettings([context]).finish()
        self._context = context

    @property
    def rays(self) -> None:
        """It wants none."""

    def sense(self, moment: SensorMoment) -> Sequence[Outgoing]:
        """Feel once.

        Raises:
            SimError: the world knows no contacts.
        """
        if "contacts" not in moment.world.capabilities:
            raise SimError(f"{where_it_is(self._context)}: its world lacks contacts")
        touches = any(self._context.robot_id in contact for contact in moment.world.contacts())
        return (Outgoing(self._context.setup.topic, "std_msgs/Bool", {"data": touches}),)
