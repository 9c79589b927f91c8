"""How a process becomes a node: once, under a name, with a master that answers."""

from __future__ import annotations

import logging
import time
import warnings

from rqt_mrta_py.errors import MissingDependencyError, TransportError
from rqt_mrta_py.model import is_legal_name
from rqt_mrta_py.transport.ros1.arguments import NodeArguments
from rqt_mrta_py.transport.ros1.door import rosgraph, rospy
from rqt_mrta_py.transport.ros1.logs import own_logging
from rqt_mrta_py.transport.ros1.master import Master

__all__ = ["become_node"]

_log = logging.getLogger("rqt_mrta_py.transport")

_WAIT = 0.2
"""How long to wait before asking again for a master that is not there yet [s]."""


def become_node(name: str, arguments: NodeArguments, anonymous: bool, await_master: bool) -> Master:
    """Make this process a node; signals, clock and log lines stay the program's.

    Args:
        name: without namespace.
        arguments: of the node.
        anonymous: whether to add to the name what makes it unique.
        await_master: whether to wait for a master that is not there yet.

    Returns:
        The master, asked under the node's resolved name.

    Raises:
        MissingDependencyError: ROS is not installed, or no master answers and is not waited for.
        TransportError: the name is none that ROS accepts, or the process is a node already.
    """
    if not is_legal_name(name) or "/" in name or "~" in name:
        raise TransportError(f"{name!r} cannot be the name of a node: letters, digits and _, a letter first")
    ros = rospy()
    if ros.core.is_initialized():
        raise TransportError(f"{name}: this process is a ROS node already; it can be one only once")
    uri = rosgraph().get_master_uri()
    _find(Master(uri, f"{arguments.namespace}{name}"), await_master)
    ros.names._set_caller_id(f"{arguments.namespace}unnamed")
    with own_logging(), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        ros.init_node(
            name,
            argv=[name, *arguments.passed_on],
            anonymous=anonymous,
            disable_signals=True,
            disable_rosout=True,
            disable_rostime=True,
        )
    return Master(uri, ros.get_name())


def _find(master: Master, wait: bool) -> None:
    """Make sure that a master answers."""
    told = False
    while True:
        try:
            master.ask("getPid")
        except TransportError as error:
            if not wait:
                raise MissingDependencyError(str(error)) from error
            if not told:
                _log.warning("%s; waiting for it", error)
                told = True
            time.sleep(_WAIT)
        else:
            return
