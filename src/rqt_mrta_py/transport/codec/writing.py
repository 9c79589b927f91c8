"""Writers of messages: a function is written, as Python text, for one type.

Such a function trusts its values and lets Python's own checks find those that do not fit; what exactly is wrong
with them is then looked up by ``misfits``, off the hot path.
"""

from __future__ import annotations

import struct
from functools import lru_cache
from typing import Any, Callable, Dict, List, Mapping, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport.codec.definitions import Definition, Field
from rqt_mrta_py.transport.codec.misfits import find_misfit
from rqt_mrta_py.transport.codec.values import Texts, bytes_of, elements_of, truth_of, truths_of, words_of
from rqt_mrta_py.transport.codec.wire import BYTE_TYPES, NUMBERS, WORDS, Sizes, duration_words, time_words

__all__ = ["compile_encoder"]

_FAULTS = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError, struct.error)
"""What Python raises for values that do not fit."""

_NO_ELEMENTS = r"b'\0\0\0\0'"
"""A string or an array of any length, on the wire, with nothing in it."""


def compile_encoder(definition: Definition) -> Callable[[Mapping[str, Any]], bytes]:
    """Write the function that serialises messages of one type.

    Args:
        definition: of the type.

    Returns:
        From nested fields to bytes; raises TransportError naming type and path for what does not fit.
    """

    def fault(fields: Any, error: Exception) -> TransportError:
        return TransportError(f"{definition.type}: {find_misfit(definition, fields) or error}")

    return _EncoderText(definition, fault).build()


class _EncoderText:
    """The text of one encoder and of the helpers it calls for elements of arrays."""

    def __init__(self, definition: Definition, fault: Callable[[Any, Exception], TransportError]) -> None:
        self._definition = definition
        self._sizes = Sizes(definition)
        self._space: Dict[str, Any] = {
            "MISSING": object(),
            "ZERO": b"\0",
            "Misfit": ValueError,
            "FAULTS": _FAULTS,
            "fault": fault,
            "pack": struct.pack,
            "texts": Texts(),
            "elements": elements_of,
            "as_bytes": bytes_of,
            "truth": truth_of,
            "truths": truths_of,
            "words": words_of,
            # Most messages of a tick carry its time. Types are told apart, for True is no time although it is 1.
            "time_words": lru_cache(maxsize=16, typed=True)(time_words),
            "duration_words": lru_cache(maxsize=16, typed=True)(duration_words),
            "join": b"".join,
        }
        self._helpers: List[str] = []
        self._known: Dict[str, str] = {}

    def build(self) -> Callable[[Mapping[str, Any]], bytes]:
        """Compile the text and give the function."""
        body = self._body(self._definition.type)
        text = "".join(self._helpers) + (
            "def write(f):\n    try:\n"
            + "".join(f"        {line}\n" for line in body)
            + "    except FAULTS as error:\n        raise fault(f, error) from error\n"
        )
        exec(compile(text, "<encoder of messages>", "exec"), self._space)
        function: Callable[[Mapping[str, Any]], bytes] = self._space["write"]
        return function

    def constant(self, prefix: str, value: Any) -> str:
        """Name a value that the text refers to."""
        name = f"{prefix}_{len(self._space)}"
        self._space[name] = value
        return name

    def helper(self, type_name: str) -> str:
        """Write, once, the function that serialises one type."""
        name = self._known.get(type_name)
        if name is None:
            name = self._known[type_name] = f"write_{len(self._known)}"
            body = self._body(type_name)
            self._helpers.append(f"def {name}(f):\n" + "".join(f"    {line}\n" for line in body))
        return name

    def _body(self, type_name: str) -> List[str]:
        walk = _Walk(self, self._definition, self._sizes)
        walk.message(type_name, "f")
        return [*walk.lines, walk.result()]


class _Walk:
    """Lines that take the fields of one message apart, and the chunks of bytes they become.

    A contained message that is left out is not taken apart: a second branch sets its parts to their zeros.
    """

    def __init__(self, text: _EncoderText, definition: Definition, sizes: Sizes) -> None:
        self.lines: List[str] = []
        self._text = text
        self._definition = definition
        self._sizes = sizes
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
        fields = self._definition.specs[type_name].fields
        known = self._text.constant("known", frozenset(item.name for item in fields))
        self._line(f"if not {known}.issuperset({source}): raise Misfit")
        parts: List[Tuple[str, str]] = []
        for item in fields:
            if item.is_array:
                parts.append(self._array(item, source))
            elif item.is_primitive:
                parts.extend(self._primitive(item, source))
            else:
                parts.extend(self._contained(item, source))
        if not fields:
            # An empty list has passed so far.
            self._line(f"{source}.keys")
        return parts

    def result(self) -> str:
        """Give the line that returns the bytes."""
        self._flush()
        if len(self._chunks) == 1:
            return f"return {self._chunks[0]}"
        return f"return join(({', '.join(self._chunks)}{',' if self._chunks else ''}))"

    def _line(self, text: str) -> None:
        self.lines.append(self._indent + text)

    def _name(self) -> str:
        self._count += 1
        return f"v{self._count}"

    def _pack(self, code: str, value: str) -> None:
        self._codes.append(code)
        self._values.append(value)

    def _flush(self) -> None:
        if self._codes:
            pack = self._text.constant("pack", struct.Struct("<" + "".join(self._codes)).pack)
            self._chunks.append(f"{pack}({', '.join(self._values)})")
            self._codes, self._values = [], []

    def _chunk(self, name: str) -> None:
        self._flush()
        self._chunks.append(name)

    def _contained(self, item: Field, source: str) -> List[Tuple[str, str]]:
        name = self._name()
        self._line(f"{name} = {source}.get('{item.name}', MISSING)")
        self._line(f"if {name} is not MISSING:")
        self._indent += "    "
        parts = self.message(item.type, name)
        self._indent = self._indent[4:]
        if parts:
            self._line("else:")
            for zero in sorted({zero for _, zero in parts}):
                targets = [part for part, own in parts if own == zero]
                self._line(f"    {' = '.join(targets)} = {zero}")
        return parts

    def _primitive(self, item: Field, source: str) -> List[Tuple[str, str]]:
        name = self._name()
        if item.type == "string":
            self._line(f"{name} = texts[{source}.get('{item.name}', '')]")
            self._chunk(name)
            return [(name, _NO_ELEMENTS)]
        if item.type in WORDS:
            seconds = self._name()
            self._line(f"{seconds}, {name} = {item.type}_words({source}.get('{item.name}', 0))")
            self._pack(WORDS[item.type][0], seconds)
            self._pack(WORDS[item.type][1], name)
            return [(seconds, "0"), (name, "0")]
        zero = "False" if item.type == "bool" else "0"
        self._line(f"{name} = {source}.get('{item.name}', {zero})")
        if item.type == "bool":
            self._line(f"if {name} is not True and {name} is not False: {name} = truth({name})")
        self._pack(NUMBERS[item.type], name)
        return [(name, zero)]

    def _array(self, item: Field, source: str) -> Tuple[str, str]:
        name = self._name()
        zero = _NO_ELEMENTS if item.length is None else f"ZERO * {self._sizes.element(item) * item.length}"
        self._line(f"{name} = {source}.get('{item.name}', MISSING)")
        self._line(f"if {name} is MISSING: {name} = {zero}")
        self._line("else:")
        self._indent += "    "
        if item.type in BYTE_TYPES:
            self._line(f"{name} = as_bytes({name})")
        elif item.type == "bool":
            self._line(f"{name} = truths({name})")
        else:
            self._line(f"if {name}.__class__ is not list and {name}.__class__ is not tuple: {name} = elements({name})")
        count = self._name()
        self._line(f"{count} = len({name})")
        content = self._content(item, name, count)
        if item.length is not None:
            self._line(f"if {count} != {item.length}: raise Misfit")
            self._line(f"{name} = {content}")
        elif item.type in NUMBERS and item.type not in BYTE_TYPES:
            self._line(f"{name} = pack('<I%d{NUMBERS[item.type]}' % {count}, {count}, *{name})")
        else:
            self._line(f"{name} = pack('<I', {count}) + {content}")
        self._indent = self._indent[4:]
        self._chunk(name)
        return name, zero

    def _content(self, item: Field, name: str, count: str) -> str:
        if item.type in BYTE_TYPES:
            return name
        if item.type in NUMBERS:
            return f"pack('<%d{NUMBERS[item.type]}' % {count}, *{name})"
        if item.type in WORDS:
            return f"pack('<%d{WORDS[item.type][0]}' % (2 * {count}), *words({item.type}_words, {name}))"
        writer = "texts.__getitem__" if item.type == "string" else self._text.helper(item.type)
        return f"join(map({writer}, {name}))"
