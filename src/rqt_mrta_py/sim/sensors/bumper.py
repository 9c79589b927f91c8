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

    Its world must know contacts. Its parameter ``bodies``, true, says whether loose bodies count: who handles some
    feels by a bumper that does not mind them what it should never touch.
    """

    def __init__(self, context: SensorContext) -> None:
        settings = SensorSettings([context])
        self._minds_bodies = settings.switch("bodies", True)
        settings.finish()
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
        robot = self._context.robot_id
        touched = {name for contact in moment.world.contacts() if robot in contact for name in contact} - {robot}
        if touched and not self._minds_bodies:
            touched -= {body.id for body in self._context.bodies}
        touches = bool(touched)
        return (Outgoing(self._context.setup.topic, "std_msgs/Bool", {"data": touches}),)
