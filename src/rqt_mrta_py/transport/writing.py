"""Writers of messages: a function is written, as Python text, for one type.

Such a function trusts its values and lets Python's own checks find those that do not fit; what exactly is wrong
with them is then looked up by ``faults``, off the hot path.
"""

from __future__ import annotations

import struct
from typing import Any, Callable, Dict, List, Mapping, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport.definitions import Definition, Field
from rqt_mrta_py.transport.faults import find_fault
from rqt_mrta_py.transport.wire import BYTE_TYPES, NUMBERS, WORDS, Sizes, duration_words, time_words

__all__ = ["compile_encoder"]

_NOTHING: Mapping[str, Any] = {}


def compile_encoder(definition: Definition) -> Callable[[Mapping[str, Any]], bytes]:
    """Write the function that serialises messages of one type.

    Args:
        definition: of the type.

    Returns:
        From nested fields to bytes; raises TransportError naming type and path for what does not fit.
    """
    Sizes(definition)
    encode = _EncoderText(definition).build()

    def checked(fields: Mapping[str, Any]) -> bytes:
        try:
            return encode(fields)
        except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError, struct.error) as error:
            fault = find_fault(definition, fields) or str(error)
            raise TransportError(f"{definition.type}: {fault}") from error

    return checked


def _elements(value: Any) -> Any:
    """Give the elements of an array's value: a list or tuple as it is, a NumPy array as a list."""
    if isinstance(value, (list, tuple, bytes, bytearray)):
        return value
    if getattr(value, "ndim", None) == 1:
        return value.tolist()
    raise TypeError("not an array")


def _bytes(value: Any) -> bytes:
    """Give an array of bytes as bytes."""
    if isinstance(value, (bytes, bytearray, memoryview)):
        return bytes(value)
    if getattr(value, "dtype", None) == "uint8" and value.ndim == 1:
        raw: bytes = value.tobytes()
        return raw
    return bytes(_elements(value))


def _truth(value: Any) -> bool:
    """Give a truth value, which may also be NumPy's or 0 or 1."""
    if value in (0, 1) and not isinstance(value, float):
        return bool(value)
    raise TypeError("not a truth value")


def _truths(value: Any) -> List[bool]:
    return [_truth(item) for item in _elements(value)]


def _words(split: Callable[[float], Tuple[int, int]], value: Any) -> List[int]:
    return [word for item in _elements(value) for word in split(item)]


def _string(value: Any) -> bytes:
    if not isinstance(value, str):
        raise TypeError("not a string")
    raw = value.encode()
    return struct.pack("<I", len(raw)) + raw


class _EncoderText:
    """The text of one encoder and of the helpers it calls for elements of arrays."""

    def __init__(self, definition: Definition) -> None:
        self._definition = definition
        self._space: Dict[str, Any] = {
            "NOTHING": _NOTHING,
            "MISSING": object(),
            "Misfit": ValueError,
            "pack": struct.pack,
            "elements": _elements,
            "as_bytes": _bytes,
            "truth": _truth,
            "truths": _truths,
            "words": _words,
            "time_words": time_words,
            "duration_words": duration_words,
            "write_string": _string,
            "join": b"".join,
        }
        self._helpers: List[str] = []
        self._known: Dict[str, str] = {}

    def build(self) -> Callable[[Mapping[str, Any]], bytes]:
        """Compile the text and give the function."""
        root = self.helper(self._definition.type)
        exec(compile("".join(self._helpers), "<encoder of messages>", "exec"), self._space)
        function: Callable[[Mapping[str, Any]], bytes] = self._space[root]
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
            walk = _Walk(self, self._definition)
            walk.message(type_name, "f")
            lines = [*walk.lines, walk.result()]
            self._helpers.append(f"def {name}(f):\n" + "".join(f"    {line}\n" for line in lines))
        return name


class _Walk:
    """Lines that take the fields of one message apart, and the chunks of bytes they become."""

    def __init__(self, text: _EncoderText, definition: Definition) -> None:
        self.lines: List[str] = []
        self._text = text
        self._definition = definition
        self._codes: List[str] = []
        self._values: List[str] = []
        self._chunks: List[str] = []
        self._count = 0

    def message(self, type_name: str, source: str) -> None:
        """Take apart one message, which the variable ``source`` holds."""
        fields = self._definition.specs[type_name].fields
        known = self._text.constant("known", frozenset(item.name for item in fields))
        self.lines.append(f"if not {source}.keys() <= {known}: raise Misfit")
        for item in fields:
            name = self._name()
            if item.is_array:
                default = "()" if item.length is None else "MISSING"
                self._get(name, source, item.name, default)
                self._array(item, name)
            elif not item.is_primitive:
                self._get(name, source, item.name, "NOTHING")
                self.message(item.type, name)
            else:
                self._get(name, source, item.name, {"string": "''", "bool": "False"}.get(item.type, "0"))
                self._primitive(item.type, name)

    def result(self) -> str:
        """Give the line that returns the bytes."""
        self._flush()
        if len(self._chunks) == 1:
            return f"return {self._chunks[0]}"
        return f"return join(({', '.join(self._chunks)}{',' if self._chunks else ''}))"

    def _name(self) -> str:
        self._count += 1
        return f"v{self._count}"

    def _get(self, name: str, source: str, field: str, default: str) -> None:
        self.lines.append(f"{name} = {source}.get('{field}', {default})")

    def _pack(self, code: str, value: str) -> None:
        self._codes.append(code)
        self._values.append(value)

    def _flush(self) -> None:
        if self._codes:
            pack = self._text.constant("pack", struct.Struct("<" + "".join(self._codes)).pack)
            self._chunks.append(f"{pack}({', '.join(self._values)})")
            self._codes, self._values = [], []

    def _chunk(self, expression: str) -> None:
        self._flush()
        self._chunks.append(expression)

    def _primitive(self, type_name: str, name: str) -> None:
        if type_name == "string":
            self.lines.append(f"if not isinstance({name}, str): raise Misfit")
            self.lines.append(f"{name} = {name}.encode()")
            self._pack("I", f"len({name})")
            self._chunk(name)
        elif type_name in WORDS:
            seconds, nanoseconds = self._name(), self._name()
            self.lines.append(f"{seconds}, {nanoseconds} = {type_name}_words({name})")
            self._pack(WORDS[type_name][0], seconds)
            self._pack(WORDS[type_name][1], nanoseconds)
        else:
            if type_name == "bool":
                self.lines.append(f"if {name} is not True and {name} is not False: {name} = truth({name})")
            self._pack(NUMBERS[type_name], name)

    def _array(self, item: Field, name: str) -> None:
        if item.length is not None:
            # The zero of an array of fixed length is made only when it is needed.
            zero = "NOTHING" if not item.is_primitive else "''" if item.type == "string" else "0"
            self.lines.append(f"if {name} is MISSING: {name} = ({zero},) * {item.length}")
        count = self._name()
        if item.type in BYTE_TYPES:
            self.lines.append(f"{name} = as_bytes({name})")
        elif item.type == "bool":
            self.lines.append(f"{name} = truths({name})")
        else:
            self.lines.append(
                f"if {name}.__class__ is not list and {name}.__class__ is not tuple: {name} = elements({name})"
            )
        self.lines.append(f"{count} = len({name})")
        if item.length is not None:
            self.lines.append(f"if {count} != {item.length}: raise Misfit")
        else:
            self._pack("I", count)
        self._chunk(self._content(item, name, count))

    def _content(self, item: Field, name: str, count: str) -> str:
        if item.type in BYTE_TYPES:
            return name
        if item.type in NUMBERS:
            return f"pack('<%d{NUMBERS[item.type]}' % {count}, *{name})"
        if item.type in WORDS:
            return f"pack('<%d{WORDS[item.type][0]}' % (2 * {count}), *words({item.type}_words, {name}))"
        writer = "write_string" if item.type == "string" else self._text.helper(item.type)
        return f"join([{writer}(item) for item in {name}])"
