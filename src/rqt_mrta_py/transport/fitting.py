"""Whether a connection carries what a subscription asks for, and how to read it."""

from __future__ import annotations

from typing import Optional, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Connection, FieldReader, Subscription

__all__ = ["reader_for"]


def reader_for(
    codec: Codec, connection: Connection, subscription: Subscription
) -> Tuple[Tuple[str, ...], Optional[FieldReader]]:
    """Prepare reading what a subscription asks for.

    Args:
        codec: compiles the reader.
        connection: whose topic the subscription means.
        subscription: names type and fields.

    Returns:
        The paths to be read, with those optional ones that the connection has; their reader, None if there are none.

    Raises:
        TransportError: the connection carries another type, or its definition lacks a field.
    """
    wanted = subscription.type
    if wanted and wanted != connection.type:
        raise TransportError(f"carries {connection.type}, subscribed to as {wanted}")
    there = [path for path in subscription.optional if _has(codec, connection, path)]
    paths = tuple(dict.fromkeys((*subscription.fields, *there)))
    return paths, codec.compile(connection, paths) if paths else None


def _has(codec: Codec, connection: Connection, path: str) -> bool:
    try:
        codec.compile(connection, (path,))
    except TransportError:
        return False
    return True
