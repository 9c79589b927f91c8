"""Connections that do not fit: what differs between the definitions of their two ends."""

from __future__ import annotations

import difflib
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, List, Mapping

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Connection
from rqt_mrta_py.transport.codec.definitions import MessageSpec, parse_definition
from rqt_mrta_py.transport.ros1.door import rospy

__all__ = ["Misfit", "Misfits", "difference", "watch_refusals"]

_ANY = "*"


@dataclass(frozen=True)
class Misfit:
    """Two ends of a topic that take it to carry different things.

    Attributes:
        topic: resolved.
        caller: the node at the other end.
        text: what does not fit, in one line.
        difference: a unified diff of the two definitions without comments; empty if one of them is not known.
    """

    topic: str
    caller: str
    text: str
    difference: str = field(repr=False, default="")


class Misfits:
    """Compares what connections carry with what is known here, and with one another.

    Args:
        codec: knows types.
        report: is told of each misfit.
    """

    def __init__(self, codec: Codec, report: Callable[[Misfit], None]) -> None:
        self._codec = codec
        self._report = report
        self._latest: Dict[str, Connection] = {}

    def check(self, connection: Connection) -> None:
        """Compare a new connection with what is known, and with the one before it on the same topic."""
        topic, type_name, caller = connection.topic, connection.type, connection.caller
        try:
            known = self._codec.connection(topic, type_name)
        except TransportError:
            known = connection
        if known.md5 != connection.md5:
            text = (
                f"{caller} publishes {topic} as {type_name} with md5 {connection.md5}; "
                f"known here is {type_name} with md5 {known.md5}; it is read as its publisher defines it"
            )
            self._tell(connection, text, known, "known here")
        before = self._latest.get(topic, connection)
        self._latest[topic] = connection
        if (before.type, before.md5) != (type_name, connection.md5):
            text = (
                f"{caller} publishes {topic} as {type_name} with md5 {connection.md5}, "
                f"{before.caller} as {before.type} with md5 {before.md5}"
            )
            self._tell(connection, text, before, before.caller)

    def _tell(self, connection: Connection, text: str, other: Connection, name: str) -> None:
        self._report(Misfit(connection.topic, connection.caller, text, difference(other, connection, name)))


def difference(ours: Connection, theirs: Connection, whose: str) -> str:
    """Tell two definitions apart.

    Args:
        ours: of which the lines with ``-`` are; only type and definition count.
        theirs: of which the lines with ``+`` are, under its caller's name.
        whose: what the former is called.

    Returns:
        A unified diff of what they declare, without comments; empty if a definition is not known or they declare
        the same.
    """
    if not (ours.definition and theirs.definition):
        return ""
    return "\n".join(difflib.unified_diff(_declared(ours), _declared(theirs), whose, theirs.caller, lineterm="", n=1))


def watch_refusals(report: Callable[[Misfit], None]) -> None:
    """Be told of subscribers whose definition does not fit what this process publishes; rospy refuses them.

    Args:
        report: is told once for each subscriber and definition, in a thread of rospy's.
    """
    server: Any = rospy().impl.tcpros_base._tcpros_server
    accept = server.topic_connection_handler
    told: List[object] = []

    def watched(sock: Any, address: Any, header: Mapping[str, str]) -> Any:
        refusal = accept(sock, address, header)
        topic, md5 = header.get("topic", ""), header.get("md5sum", _ANY)
        key = (topic, header.get("callerid"), md5)
        own = rospy().impl.registration.get_topic_manager().get_publisher_impl(topic)
        carrier = own and own.data_class
        if refusal and carrier and md5 not in (_ANY, carrier._md5sum) and key not in told:
            told.append(key)
            report(_refused(topic, header, carrier))
        return refusal

    server.topic_connection_handler = watched


def _refused(topic: str, header: Mapping[str, str], carrier: Any) -> Misfit:
    caller, md5 = header.get("callerid", ""), header["md5sum"]
    type_name = header.get("type", carrier._type)
    text = (
        f"{caller} wants {topic} as {type_name} with md5 {md5}; "
        f"it is published here as {carrier._type} with md5 {carrier._md5sum}, and {caller} does not hear it"
    )
    own = Connection(topic, carrier._type, carrier._md5sum, carrier._full_text)
    theirs = Connection(topic, type_name, md5, header.get("message_definition", ""), caller)
    return Misfit(topic, caller, text, difference(own, theirs, "published here"))


def _declared(connection: Connection) -> List[str]:
    try:
        specs = parse_definition(connection.type, connection.definition).specs
    except TransportError:
        return [line.strip() for line in connection.definition.splitlines() if line.strip()]
    return [line for name, spec in specs.items() for line in (f"MSG: {name}", *_lines(spec))]


def _lines(spec: MessageSpec) -> List[str]:
    lines = [f"{constant.type} {constant.name}={constant.text}" for constant in spec.constants]
    for item in spec.fields:
        brackets = "" if not item.is_array else f"[{'' if item.length is None else item.length}]"
        lines.append(f"{item.type}{brackets} {item.name}")
    return lines
