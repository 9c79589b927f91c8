"""The ROS master: what it is asked, and what it knows of the graph."""

from __future__ import annotations

import http.client
import threading
import xmlrpc.client
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport.ros1.door import NETWORK_ERRORS

__all__ = ["Graph", "Master"]

_PATIENCE = 5.0
"""How long an answer may take before the master counts as lost [s]."""

_SHORT_PATIENCE = 2.0
"""How long a node may take to say that it is there [s]."""

_LONG_ANSWER = 1000
"""From how long on an answer is remembered [bytes]: that list of topics is asked for twice a second."""


@dataclass(frozen=True)
class Graph:
    """What a master knows: names are resolved and in order.

    Attributes:
        types: by topic; ``*`` if the master does not know it.
        publishers: nodes by topic.
        subscribers: nodes by topic.
        services: nodes by service.
    """

    types: Mapping[str, str]
    publishers: Mapping[str, Tuple[str, ...]]
    subscribers: Mapping[str, Tuple[str, ...]]
    services: Mapping[str, Tuple[str, ...]]

    @property
    def topics(self) -> Tuple[str, ...]:
        """All topics that somebody publishes or subscribes to."""
        return tuple(sorted({*self.publishers, *self.subscribers}))

    @property
    def nodes(self) -> Tuple[str, ...]:
        """All nodes that publish, subscribe or serve."""
        kinds = (self.publishers, self.subscribers, self.services)
        return tuple(sorted({node for kind in kinds for nodes in kind.values() for node in nodes}))


class Master:
    """Asks a ROS master, one question at a time.

    Args:
        uri: where it listens.
        caller: resolved name of the node that asks.

    Attributes:
        uri: see above.
        caller: see above.

    Raises:
        TransportError: there can be no master at such a place.
    """

    def __init__(self, uri: str, caller: str) -> None:
        self.uri = uri
        self.caller = caller
        self._lock = threading.Lock()
        try:
            self._proxy = xmlrpc.client.ServerProxy(uri, transport=_PatientTransport(_PATIENCE))
        except OSError as error:
            raise TransportError(f"ROS_MASTER_URI {uri!r}: {error}; accepted is http://host:port") from error

    def ask(self, method: str, *arguments: Any) -> Tuple[bool, str, Any]:
        """Call a method of the master's API.

        Args:
            method: such as ``lookupNode``.
            arguments: after the caller's name.

        Returns:
            Whether it succeeded, what it says of it, and the value.

        Raises:
            TransportError: it does not answer, or an argument is none that it can be told.
        """
        try:
            with self._lock:
                answer = getattr(self._proxy, method)(self.caller, *arguments)
        except (TypeError, OverflowError) as error:
            raise TransportError(f"ROS cannot carry {arguments[-1]!r}: {error}") from error
        except NETWORK_ERRORS as error:
            raise TransportError(
                f"no ROS master answers at {self.uri} ({error}); start one with roscore, or set ROS_MASTER_URI"
            ) from error
        if not (isinstance(answer, list) and len(answer) == 3):
            raise TransportError(f"what answers at {self.uri} is no ROS master: it says {str(answer)[:80]!r}")
        return answer[0] == 1, str(answer[1]), answer[2]

    def reaches(self, node: str) -> bool:
        """Tell whether a node that the master knows answers.

        Args:
            node: resolved name.

        Raises:
            TransportError: the master itself does not answer.
        """
        known, _, uri = self.ask("lookupNode", node)
        if not known:
            return False
        try:
            with xmlrpc.client.ServerProxy(str(uri), transport=_PatientTransport(_SHORT_PATIENCE)) as proxy:
                proxy.getPid(self.caller)
        except NETWORK_ERRORS:
            return False
        return True

    def graph(self) -> Graph:
        """Give what it knows of nodes, topics and services.

        Raises:
            TransportError: it does not answer.
        """
        _, _, (publishers, subscribers, services) = self.ask("getSystemState")
        _, _, types = self.ask("getTopicTypes")
        return Graph(dict(sorted(types)), _by_name(publishers), _by_name(subscribers), _by_name(services))


def _by_name(pairs: List[Tuple[str, List[str]]]) -> Dict[str, Tuple[str, ...]]:
    return {name: tuple(sorted(nodes)) for name, nodes in sorted(pairs)}


class _PatientTransport(xmlrpc.client.Transport):
    """Waits no longer than it is told to, and does not take apart again the long answer that it had before."""

    accept_gzip_encoding = False

    def __init__(self, patience: float) -> None:
        super().__init__()
        self._patience = patience
        self._known: Tuple[bytes, Any] = (b"", None)

    def make_connection(self, host: Any) -> http.client.HTTPConnection:
        connection = super().make_connection(host)
        connection.timeout = self._patience
        return connection

    def parse_response(self, response: Any) -> Any:
        body = response.read()
        if body == self._known[0]:
            return self._known[1]
        parser, unmarshaller = self.getparser()
        parser.feed(body)
        parser.close()
        value = unmarshaller.close()
        if len(body) >= _LONG_ANSWER:
            self._known = (body, value)
        return value
