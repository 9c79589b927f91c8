"""The one door to rospy and what belongs to it, imported when a node is first started."""

from __future__ import annotations

import socket
from http.client import HTTPException
from typing import Any, Tuple, Type
from xml.parsers.expat import ExpatError
from xmlrpc.client import Error as XmlRpcError

from rqt_mrta_py.errors import MissingDependencyError

__all__ = ["NETWORK_ERRORS", "genpy_message", "registration_listener", "rosgraph", "rospy", "tell_rospy_the_time"]

NETWORK_ERRORS: Tuple[Type[BaseException], ...] = (
    OSError,
    socket.timeout,
    HTTPException,
    XmlRpcError,
    ExpatError,
    ValueError,
)
"""What a question to a master or to another node may end in, an answer that is none included."""

_REMEDY = (
    "install ROS 1, on Debian with: apt-get install python3-rospy, "
    "and run in a Python that sees its packages (a virtual environment: --system-site-packages)"
)


def rospy() -> Any:
    """Import rospy with the parts of it that are used here.

    Raises:
        MissingDependencyError: it is not installed.
    """
    try:
        import rospy as module
        import rospy.impl.registration
        import rospy.impl.tcpros_base
    except ImportError as error:
        raise MissingDependencyError(f"live ROS 1 needs the library rospy ({error}); {_REMEDY}") from error
    return module


def rosgraph() -> Any:
    """Import rosgraph, which knows where the master is and how connections are opened.

    Raises:
        MissingDependencyError: it is not installed.
    """
    try:
        import rosgraph as module
        import rosgraph.names
        import rosgraph.network
    except ImportError as error:
        raise MissingDependencyError(f"live ROS 1 needs the library rosgraph ({error}); {_REMEDY}") from error
    return module


def genpy_message() -> Any:
    """Give the base class that rospy demands of every message.

    Raises:
        MissingDependencyError: genpy is not installed, or another library of that name is.
    """
    try:
        from genpy import Message
    except ImportError as error:
        raise MissingDependencyError(
            f"live ROS 1 needs ROS's library genpy ({error}), not the one of that name that pip installs; {_REMEDY}"
        ) from error
    return Message


def tell_rospy_the_time(seconds: int, nanoseconds: int) -> None:
    """Set rospy's own clock, for a plugin that uses rospy by itself."""
    module = rospy().rostime
    module._rostime_current = module.Time(seconds, nanoseconds)
    condition = module.get_rostime_cond()
    with condition:
        condition.notify_all()


def registration_listener() -> Any:
    """Give the base class of those whom rospy tells what a node publishes, hears and serves."""
    from rospy.impl.registration import RegistrationListener

    return RegistrationListener
