"""Writers of messages: a function is written, as Python text, for one type, whatever is left out of a message.

Such a function trusts its values and lets Python's own checks find those that do not fit; what exactly is wrong
with them is then looked up by ``misfits``, off the hot path.
"""

from __future__ import annotations

import struct
import sys
from typing import Any, List, Mapping, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport.codec.definitions import Definition, Field
from rqt_mrta_py.transport.codec.encoder_text import Encoder, EncoderText
from rqt_mrta_py.transport.codec.misfits import find_misfit
from rqt_mrta_py.transport.codec.wire import BYTE_TYPES, NUMBERS, WORDS

__all__ = ["Walk", "compile_encoder"]

_NO_ELEMENTS = r"b'\0\0\0\0'"
"""A string or an array of any length, on the wire, with nothing in it."""


def compile_encoder(definition: Definition) -> Encoder:
    """Write the function that serialises messages of one type.

    Args:
        definition: of the type.

    Returns:
        From nested fields to bytes; raises TransportError naming type and path for what does not fit.
    """

    def refuse(fields: Mapping[str, Any]) -> bytes:
        error = sys.exc_info()[1]
        raise TransportError(f"{definition.type}: {find_misfit(definition, fields) or error}") from error

    text = EncoderText(definition, refuse)
    walk = Walk(text)
    walk.message(definition.type, "f")
    return text.function(walk.written())


class Walk:
    """Lines that take the fields of one message apart, and the chunks of bytes they become.

    A contained message that is left out is not taken apart: a second branch sets its parts to their zeros.
    """

    def __init__(self, text: EncoderText) -> None:
        self._lines: List[str] = []
        self.text = text
        self._codes: List[str] = []
        self._values: List[str] = []
        self._chunks: List[str] = []
        self._count = 0
        self._indent = ""

    def message(self, type_name: str, source: str) -> List[Tuple[str, str]]:
        """Take apart one message, which the variable ``source`` holds.

        Returns:
            The variables that its parts stand in, each with the text of its zero.
        """
        fields = self.text.definition.specs[type_name].fields
        known = self.text.constant("known", frozenset(item.name for item in fields))
        self.line(f"if not {known}.issuperset({source}): raise Misfit")
        parts: List[Tuple[str, str]] = []
        for item in fields:
            if item.is_array:
                parts.append(self._array(item, source))
            elif item.is_primitive:
                parts.extend(self.primitive(item, source))
            else:
                parts.extend(self._contained(item, source))
        if not fields:
            # An empty list has passed so far.
            self.line(f"{source}.keys")
        return parts

    def asked(self, item: Field, source: str, zero: str) -> str:
        """Give the text that asks a message for a field, and for its zero if it is left out."""
        return f"{source}.get('{item.name}', {zero})"

    def writer(self, item: Field) -> str:
        """Name the helper that writes the messages of an array."""
        name = self.text.known.get(item.type)
        if name is None:
            walk = Walk(self.text)
            walk.message(item.type, "f")
            name = self.text.known[item.type] = self.text.helper(walk.written())
        return name

    def written(self) -> List[str]:
        """Give the lines, the last of which returns the bytes."""
        self._flush()
        if len(self._chunks) == 1:
            return [*self._lines, f"return {self._chunks[0]}"]
        return [*self._lines, f"return join(({', '.join(self._chunks)}{',' if self._chunks else ''}))"]

    def line(self, text: str) -> None:
        """Add a line."""
        self._lines.append(self._indent + text)

    def name(self) -> str:
        """Name a variable of its own."""
        self._count += 1
        return f"v{self._count}"

    def pack(self, code: str, *values: str) -> None:
        """Add what goes into bytes by a code of ``struct``."""
        self._codes.append(code)
        self._values.extend(values)

    def _flush(self) -> None:
        if self._codes:
            pack = self.text.constant("pack", struct.Struct("<" + "".join(self._codes)).pack)
            self._chunks.append(f"{pack}({', '.join(self._values)})")
            self._codes, self._values = [], []

    def chunk(self, name: str) -> None:
        """Add bytes that a variable holds."""
        self._flush()
        self._chunks.append(name)

    def _contained(self, item: Field, source: str) -> List[Tuple[str, str]]:
        name = self.name()
        self.line(f"{name} = {self.asked(item, source, 'MISSING')}")
        self.line(f"if {name} is not MISSING:")
        self._indent += "    "
        parts = self.message(item.type, name)
        self._indent = self._indent[4:]
        if parts:
            self.line("else:")
            for zero in sorted({zero for _, zero in parts}):
                targets = [part for part, own in parts if own == zero]
                self.line(f"    {' = '.join(targets)} = {zero}")
        return parts

    def primitive(self, item: Field, source: str) -> List[Tuple[str, str]]:
        """Take one number, time or string; returns as ``message`` does."""
        name = self.name()
        if item.type == "string":
            text = self.asked(item, source, "''")
            self.line(f"{name} = texts[{text}]")
            self.chunk(name)
            return [(name, _NO_ELEMENTS)]
        if item.type in WORDS:
            seconds = self.name()
            self.line(f"{seconds}, {name} = {item.type}_words({self.asked(item, source, '0')})")
            self.pack(WORDS[item.type][0], seconds)
            self.pack(WORDS[item.type][1], name)
            return [(seconds, "0"), (name, "0")]
        zero = "False" if item.type == "bool" else "0"
        self.line(f"{name} = {self.asked(item, source, zero)}")
        if item.type == "bool":
            self.line(f"if {name} is not True and {name} is not False: {name} = truth({name})")
        self.pack(NUMBERS[item.type], name)
        return [(name, zero)]

    def _array(self, item: Field, source: str) -> Tuple[str, str]:
        name = self.name()
        zero = _NO_ELEMENTS if item.length is None else f"ZERO * {self.text.sizes.element(item) * item.length}"
        self.line(f"{name} = {self.asked(item, source, 'MISSING')}")
        self.line(f"if {name} is MISSING: {name} = {zero}")
        self.line("else:")
        self._indent += "    "
        self.elements(item, name)
        self._indent = self._indent[4:]
        self.chunk(name)
        return name, zero

    def elements(self, item: Field, name: str) -> None:
        """Make the bytes of an array of the variable that holds its elements."""
        if item.type in BYTE_TYPES:
            self.line(f"{name} = as_bytes({name})")
        elif item.type == "bool":
            self.line(f"{name} = truths({name})")
        else:
            self.line(f"if {name}.__class__ is not list and {name}.__class__ is not tuple: {name} = elements({name})")
        count = self.name()
        self.line(f"{count} = len({name})")
        content = self._content(item, name, count)
        if item.length is not None:
            self.line(f"if {count} != {item.length}: raise Misfit")
            self.line(f"{name} = {content}")
        elif item.type in NUMBERS and item.type not in BYTE_TYPES:
            self.line(f"{name} = pack('<I%d{NUMBERS[item.type]}' % {count}, {count}, *{name})")
        else:
            self.line(f"{name} = pack('<I', {count}) + {content}")

    def _content(self, item: Field, name: str, count: str) -> str:
        if item.type in BYTE_TYPES:
            return name
        if item.type in NUMBERS:
            return f"pack('<%d{NUMBERS[item.type]}' % {count}, *{name})"
        if item.type in WORDS:
            return f"pack('<%d{WORDS[item.type][0]}' % (2 * {count}), *words({item.type}_words, {name}))"
        writer = "texts.__getitem__" if item.type == "string" else self.writer(item)
        return f"join(map({writer}, {name}))"
