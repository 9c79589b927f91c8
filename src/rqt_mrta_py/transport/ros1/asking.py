"""What a node asks: its master for names and parameters, services for answers."""

from __future__ import annotations

from typing import Any, Mapping

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec
from rqt_mrta_py.model import resolve_name
from rqt_mrta_py.transport.ros1 import services
from rqt_mrta_py.transport.ros1.master import Graph, Master

__all__ = ["Asking"]


class Asking:
    """A node as far as it asks others.

    Args:
        codec: reads and writes messages.
        remappings: from name to name.
        master: is asked, under the node's name.

    Attributes:
        name: of the node, resolved.
        codec: see above.
    """

    def __init__(self, codec: Codec, remappings: Mapping[str, str], master: Master) -> None:
        self.name = master.caller
        self.codec = codec
        self._remappings = remappings
        self._master = master

    def resolve(self, name: str) -> str:
        """Resolve and remap a name.

        Raises:
            TransportError: ROS does not accept it.
        """
        try:
            return resolve_name(name, self.name, self._remappings)
        except ValueError as error:
            raise TransportError(f"{self.name}: {error}") from error

    def call(self, name: str, type_name: str, fields: Mapping[str, Any], timeout: float) -> Mapping[str, Any]:
        """Ask a service, not one of this node while its lock is held.

        Args:
            name: is resolved and remapped.
            type_name: ``pkg/Srv``.
            fields: of the request.
            timeout: how long it may take in all, until it appears included [s].

        Raises:
            TransportError: it is not there, does not answer in time, refuses, or is of another type.
        """
        service = services.ServiceType.find(type_name, self.codec)
        return services.call(
            self.resolve(name), service, fields, timeout, codec=self.codec, master=self._master, caller=self.name
        )

    def parameter(self, name: str, default: Any = None) -> Any:
        """Give a parameter as plain builtins.

        Args:
            name: global, relative or private (``~x``).
            default: what it is where nobody has set it.

        Raises:
            TransportError: the name is not accepted, or no master answers.
        """
        found, _, value = self._master.ask("getParam", self.resolve(name))
        return value if found else default

    def parameters(self, namespace: str) -> Mapping[str, Any]:
        """Give all parameters of a namespace, nested as their names are; empty if there are none.

        Raises:
            TransportError: as ``parameter``.
        """
        value = self.parameter(namespace, {})
        return value if isinstance(value, dict) else {}

    def set_parameter(self, name: str, value: Any) -> None:
        """Set a parameter.

        Raises:
            TransportError: as ``parameter``, or the value is none that a parameter can have.
        """
        done, text, _ = self._master.ask("setParam", self.resolve(name), value)
        if not done:
            raise TransportError(f"parameter {name}: cannot be set: {text}")

    def reaches(self, node: str) -> bool:
        """Tell whether a node that the master knows answers; one that was killed is known until its name is taken anew.

        Args:
            node: resolved name.

        Raises:
            TransportError: no master answers.
        """
        return self._master.reaches(node)

    def graph(self) -> Graph:
        """Give what the master knows of nodes, topics and services.

        Raises:
            TransportError: no master answers.
        """
        return self._master.graph()
