"""The codec of the stream: fields into bytes and back, with or without ROS."""

from __future__ import annotations

from functools import partial
from typing import Any, Callable, Dict, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import Column, Connection, FieldReader, Page
from rqt_mrta_py.transport.codec.columns import ColumnEncoder
from rqt_mrta_py.transport.codec.definitions import Definition, parse_definition
from rqt_mrta_py.transport.codec.forms import FormedEncoder
from rqt_mrta_py.transport.codec.reading import compile_decoder, compile_reader
from rqt_mrta_py.transport.codec.types import TypeLibrary

__all__ = ["RosCodec"]

_Key = Tuple[str, str]
"""Type and definition: two bags may carry one type's name with different definitions."""


class RosCodec:
    """Implements ``hooks.Codec`` for ROS 1 messages; functions are compiled once and kept.

    Args:
        lookup: from ``pkg/Msg`` to the text of its ``.msg`` file, for types that are not standard; None where there
            is none.
    """

    def __init__(self, lookup: Callable[[str], Optional[str]]) -> None:
        self._library = TypeLibrary(lookup)
        self._described: Dict[str, Tuple[str, str]] = {}
        self._parsed: Dict[_Key, Definition] = {}
        self._readers: Dict[Tuple[_Key, Tuple[str, ...]], FieldReader] = {}
        self._decoders: Dict[_Key, Callable[[bytes], Dict[str, Any]]] = {}
        self._encoders: Dict[str, FormedEncoder] = {}
        self._column_encoders: Dict[str, ColumnEncoder] = {}

    def connection(self, topic: str, type_name: str, caller: str = "", latched: bool = False) -> Connection:
        """Describe a publisher's way onto a topic; see ``hooks.Codec``."""
        described = self._described.get(type_name)
        if described is None:
            definition = self._library.definition(type_name)
            described = self._described[type_name] = (definition.md5, definition.full_text)
        return Connection(topic, type_name, described[0], described[1], caller, latched)

    def compile(self, connection: Connection, paths: Sequence[str]) -> FieldReader:
        """Prepare reading fields of a connection's messages; see ``hooks.Codec``."""
        key = ((connection.type, connection.definition), tuple(paths))
        reader = self._readers.get(key)
        if reader is None:
            reader = self._readers[key] = compile_reader(self._definition(connection), key[1])
        return reader

    def encode(self, type_name: str, fields: Mapping[str, Any]) -> bytes:
        """Serialise a message; see ``hooks.Codec``."""
        try:
            encoder = self._encoders[type_name]
        except KeyError:
            encoder = self._encoders[type_name] = FormedEncoder(self._library.definition(type_name))
        return encoder.write(fields)

    def encode_columns(self, type_name: str, columns: Mapping[str, Column], count: int) -> Page:
        """Serialise messages column by column; see ``hooks.Codec``."""
        encoder = self._column_encoders.get(type_name)
        if encoder is None:
            definition = self._library.definition(type_name)
            encoder = self._column_encoders[type_name] = ColumnEncoder(definition, partial(self.encode, type_name))
        return encoder.write(columns, count)

    def decode(self, connection: Connection, raw: bytes) -> Dict[str, Any]:
        """Turn a whole message into nested builtins; see ``hooks.Codec``."""
        key = (connection.type, connection.definition)
        decoder = self._decoders.get(key)
        if decoder is None:
            decoder = self._decoders[key] = compile_decoder(self._definition(connection))
        return decoder(raw)

    def _definition(self, connection: Connection) -> Definition:
        key = (connection.type, connection.definition)
        definition = self._parsed.get(key)
        if definition is None:
            definition = self._parsed[key] = parse_definition(*key)
        return definition
