"""The arguments that ROS gives to nodes: remappings, private parameters, name and namespace."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import List, Mapping, Sequence, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.model import is_legal_name

__all__ = ["NodeArguments"]

_ASSIGN = ":="


@dataclass(frozen=True)
class NodeArguments:
    """What the arguments of one node say.

    Attributes:
        namespace: with a slash at both ends.
        remappings: from name to name, as written.
        passed_on: what rospy sees to itself: name, log file and private parameters.
    """

    namespace: str
    remappings: Mapping[str, str]
    passed_on: Tuple[str, ...]

    @classmethod
    def read(cls, arguments: Sequence[str], environment: Mapping[str, str] = os.environ) -> NodeArguments:
        """Read arguments.

        Args:
            arguments: ``a:=b``, ``_p:=v``, ``__ns:=``, ``__name:=`` and the like.
            environment: its ``ROS_NAMESPACE`` counts where no argument names a namespace.

        Raises:
            TransportError: one is no such argument, or names something that ROS does not accept.
        """
        namespace = environment.get("ROS_NAMESPACE", "")
        remappings = {}
        passed_on: List[str] = []
        for argument in arguments:
            source, assigned, target = argument.partition(_ASSIGN)
            if not (source and assigned and target):
                raise TransportError(
                    f"{argument!r} is no argument of a ROS node; accepted are name:=name, _parameter:=value, "
                    "__name:=name and __ns:=namespace"
                )
            if source == "__ns":
                namespace = target
            elif source.startswith("_"):
                passed_on.append(argument)
            else:
                _check(argument, source, target)
                remappings[source] = target
        inner = namespace.strip("/")
        if inner:
            _check(f"namespace {namespace!r}", inner)
        return cls(f"/{inner}/" if inner else "/", remappings, tuple(passed_on))


def _check(what: str, *names: str) -> None:
    for name in names:
        if not is_legal_name(name):
            raise TransportError(f"{what}: {name!r} is not a name that ROS accepts: letters, digits, _ and /")
