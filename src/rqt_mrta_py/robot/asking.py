"""Questions to one robot's agent and behaviours: what they raise is told with robot, part and time."""

from __future__ import annotations

from typing import Callable, Iterable, List, TypeVar

from rqt_mrta_py.errors import MrtaError, RobotError
from rqt_mrta_py.hooks import AnyOutgoing, OutgoingRows
from rqt_mrta_py.hooks.answers import message_breach, rows_breach
from rqt_mrta_py.robot.perception import Senses

__all__ = ["Asking", "checked", "extend"]

_Result = TypeVar("_Result")


class Asking:
    """Asks on behalf of one robot.

    Args:
        robot_id: normalised.
        senses: know the time.
    """

    def __init__(self, robot_id: str, senses: Senses) -> None:
        self._robot_id = robot_id
        self._senses = senses

    def ask(self, who: str, question: Callable[[], _Result]) -> _Result:
        """Ask somebody something.

        Args:
            who: names agent or behaviour.
            question: to be called.

        Raises:
            RobotError: it raised. Errors that already speak to the user pass as they are.
        """
        try:
            return question()
        except MrtaError:
            raise
        except Exception as error:
            raise self.failure(who, error) from error

    def failure(self, who: str, error: Exception) -> RobotError:
        """Make the error that says who failed, when and why."""
        cause = f"{type(error).__name__}: {error}"
        return RobotError(f"{self._robot_id}: {who} failed at {self._senses.now:.3f} s: {cause}")


def checked(value: _Result, wanted: type) -> _Result:
    """Give an answer that is of the type wanted.

    Raises:
        TypeError: it is not.
    """
    if not isinstance(value, wanted):
        raise TypeError(f"answered {value!r}; accepted is {wanted.__name__}")
    return value


def extend(says: List[AnyOutgoing], messages: Iterable[AnyOutgoing], *, rows: bool = False) -> None:
    """Add messages to what is said, up to the first that is none.

    Args:
        says: what is said so far.
        messages: to be added.
        rows: whether many may come together, as agents say them.

    Raises:
        TypeError: one is no message.
    """
    for message in messages:
        breach = rows_breach(message) if rows and isinstance(message, OutgoingRows) else message_breach(message)
        if breach is not None:
            raise TypeError(breach)
        says.append(message)
