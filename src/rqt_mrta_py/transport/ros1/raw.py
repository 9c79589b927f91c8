"""Message classes for rospy that carry bytes: what is in them is the codec's business."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, Dict

from rqt_mrta_py.hooks import Connection
from rqt_mrta_py.transport.ros1.door import genpy_message

__all__ = ["any_type", "carrier_of", "filled"]


@lru_cache(maxsize=1)
def any_type() -> Any:
    """Give the class of messages of whatever type a publisher says it has."""
    return _raw_class("AnyRawMessage", "*", "*", "")


def carrier_of(connection: Connection) -> Any:
    """Make the class of messages of one type, without anything generated for it.

    Args:
        connection: tells type, md5 and definition.
    """
    name = connection.type.replace("/", "_")
    return _raw_class(name, connection.type, connection.md5, connection.definition)


def filled(carrier: Any, raw: bytes) -> Any:
    """Make a message of a raw class.

    Args:
        carrier: the class.
        raw: the message's bytes.
    """
    message = carrier()
    message.raw = raw
    return message


def _raw_class(name: str, type_name: str, md5: str, definition: str) -> Any:
    def start(self: Any, *_values: object) -> None:
        self.raw = b""

    def serialize(self: Any, buffer: Any) -> None:
        buffer.write(self.raw)

    def deserialize(self: Any, raw: bytes) -> Any:
        self.raw = raw
        return self

    body: Dict[str, Any] = {
        "__slots__": ("raw",),
        "_slot_types": (),
        "_type": type_name,
        "_md5sum": md5,
        "_full_text": definition,
        "_has_header": False,
        "__init__": start,
        "serialize": serialize,
        "deserialize": deserialize,
    }
    return type(name, (genpy_message(),), body)
