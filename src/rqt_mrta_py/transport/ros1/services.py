"""Services: served and called by the texts of ``.srv`` files, with no class generated for their types."""

from __future__ import annotations

import hashlib
import io
import logging
import socket
import struct
import time
from dataclasses import dataclass
from typing import Any, Callable, List, Mapping

from rqt_mrta_py.errors import MrtaError, TransportError
from rqt_mrta_py.hooks import Codec, Connection
from rqt_mrta_py.transport.codec.definitions import parse_definition
from rqt_mrta_py.transport.ros1.door import NETWORK_ERRORS, rosgraph, rospy
from rqt_mrta_py.transport.ros1.master import Master
from rqt_mrta_py.transport.ros1.raw import carrier_of, filled

__all__ = ["ServiceType", "call", "serve"]

_log = logging.getLogger("rqt_mrta_py.transport")

_AGAIN = 0.05
"""How long to wait before asking again for a service that is not there yet [s]."""

_length = struct.Struct("<I")
_answer_head = struct.Struct("<BI")

Handler = Callable[[Mapping[str, Any]], Mapping[str, Any]]


@dataclass(frozen=True)
class ServiceType:
    """What a service is asked and what it answers.

    Attributes:
        name: ``pkg/Srv``.
        request: type, md5 and definition of what it is asked.
        response: of what it answers.
        md5: of both, as ROS counts it.
    """

    name: str
    request: Connection
    response: Connection
    md5: str

    @classmethod
    def find(cls, name: str, codec: Codec) -> ServiceType:
        """Find a type by name.

        Args:
            name: ``pkg/Srv``.
            codec: knows the types ``pkg/SrvRequest`` and ``pkg/SrvResponse``.

        Raises:
            TransportError: it does not.
        """
        parts = [codec.connection("", f"{name}{part}") for part in ("Request", "Response")]
        texts = [parse_definition(part.type, part.definition).md5_text for part in parts]
        return cls(name, parts[0], parts[1], hashlib.md5("".join(texts).encode()).hexdigest())


def serve(name: str, service: ServiceType, codec: Codec, lock: Any, handler: Handler) -> None:
    """Answer requests from now on.

    Args:
        name: resolved.
        service: its type.
        codec: reads requests and writes answers.
        lock: is held while a request is handled.
        handler: from the fields of a request to those of its answer; an MrtaError refuses it.

    Raises:
        TransportError: this node serves it already.
    """
    ros = rospy()
    response_class = carrier_of(service.response)

    def handle(request: Any) -> Any:
        try:
            with lock:
                answer = handler(codec.decode(service.request, request.raw))
            return filled(response_class, codec.encode(service.response.type, answer))
        except MrtaError as error:
            raise ros.ServiceException(str(error)) from error
        except Exception:
            _log.exception("service=%s failed", name)
            raise

    def failed(*_what: object) -> None:
        """Say nothing more: it has been logged."""

    parts = {"_request_class": carrier_of(service.request), "_response_class": response_class}
    service_class = type("RawService", (), {"_type": service.name, "_md5sum": service.md5, **parts})
    try:
        ros.Service(name, service_class, handle, error_handler=failed)
    except ros.ServiceException as error:
        raise TransportError(f"service {name}: {error}") from error


def call(
    name: str,
    service: ServiceType,
    fields: Mapping[str, Any],
    timeout: float,
    *,
    codec: Codec,
    master: Master,
    caller: str,
) -> Mapping[str, Any]:
    """Ask a service; it may still have to appear.

    Args:
        name: resolved.
        service: its type.
        fields: of the request.
        timeout: how long it may take in all [s].
        codec: writes the request and reads the answer.
        master: knows who serves it.
        caller: resolved name of the node that asks.

    Returns:
        The fields of the answer.

    Raises:
        TransportError: it is not there, does not answer in time, refuses, or is of another type.
    """
    request = codec.encode(service.request.type, fields)
    deadline = time.monotonic() + timeout
    found, text, uri = master.ask("lookupService", name)
    while not found and time.monotonic() + _AGAIN < deadline:
        time.sleep(_AGAIN)
        found, text, uri = master.ask("lookupService", name)
    if not found:
        raise TransportError(f"service {name}: nobody serves it ({text}); {timeout:g} s were waited")
    header = {"service": name, "md5sum": service.md5, "callerid": caller, "type": service.name}
    try:
        left = max(deadline - time.monotonic(), _AGAIN)
        with socket.create_connection(rospy().core.parse_rosrpc_uri(uri), left) as connection:
            raw = _exchange(connection, name, header, request, deadline)
    except NETWORK_ERRORS as error:
        raise TransportError(f"service {name}: no answer from {uri}: {error}") from error
    return codec.decode(service.response, raw)


def _exchange(
    connection: socket.socket, name: str, header: Mapping[str, str], request: bytes, deadline: float
) -> bytes:
    network = rosgraph().network
    network.write_ros_handshake_header(connection, dict(header))
    try:
        reply = network.read_ros_handshake_header(connection, io.BytesIO(), 4096)
    except network.ROSHandshakeException as error:
        raise OSError(f"it does not speak as a service does: {error}") from error
    if "error" in reply:
        raise TransportError(f"service {name}: refused: {reply['error']}")
    connection.sendall(_length.pack(len(request)) + request)
    good, size = _answer_head.unpack(_received(connection, _answer_head.size, deadline))
    answer = _received(connection, size, deadline)
    if not good:
        raise TransportError(f"service {name}: {answer.decode(errors='replace')}")
    return answer


def _received(connection: socket.socket, size: int, deadline: float) -> bytes:
    parts: List[bytes] = []
    missing = size
    while missing:
        connection.settimeout(max(deadline - time.monotonic(), 0.001))
        part = connection.recv(min(missing, 1 << 16))
        if not part:
            raise OSError("the connection was closed")
        parts.append(part)
        missing -= len(part)
    return b"".join(parts)
