"""Whether a connection carries what a subscription asks for, and how to read it."""

from __future__ import annotations

from typing import Optional

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Connection, FieldReader, Subscription

__all__ = ["reader_for"]


def reader_for(codec: Codec, connection: Connection, subscription: Subscription) -> Optional[FieldReader]:
    """Prepare reading what a subscription asks for.

    Args:
        codec: compiles the reader.
        connection: whose topic the subscription means.
        subscription: names type and fields.

    Returns:
        The reader of its fields; None if it asks for nothing of the content.

    Raises:
        TransportError: the connection carries another type, or its definition lacks a field.
    """
    wanted = subscription.type
    if wanted and wanted != connection.type:
        raise TransportError(f"carries {connection.type}, subscribed to as {wanted}")
    return codec.compile(connection, subscription.fields) if subscription.fields else None
