"""Readers of fields: a function is written, as Python text, for one definition and the paths asked for.

Such a function walks over a message once. Neighbouring numbers are unpacked together, what nobody asked for is
stepped over, and a message whose length does not fit its definition is refused whatever was asked for. Before
anything is allocated, a length found in the bytes is held against the bytes that are left.
"""

from __future__ import annotations

import struct
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport.codec.definitions import Definition, Field
from rqt_mrta_py.transport.codec.wire import BYTE_TYPES, MOST_EMPTY, NUMBERS, WORDS, Sizes

__all__ = ["compile_decoder", "compile_reader"]

_STRING = "str(raw[{start}:end], 'utf-8', 'backslashreplace')"
_NANOSECONDS = "1000000000"
_LONGEST_PAD = 2**16


def compile_reader(definition: Definition, paths: Sequence[str]) -> Callable[[bytes], Tuple[Any, ...]]:
    """Write the function that reads some fields.

    Args:
        definition: of the messages to be read.
        paths: joined by ``/``.

    Returns:
        From bytes to the values of the paths, in their order; raises TransportError for bytes that do not fit.

    Raises:
        TransportError: the definition lacks a path; names both.
    """
    for path in paths:
        _check_path(definition, path)
    writer = _ReaderText(definition)
    values = writer.walk([tuple(path.split("/")) for path in paths])
    return writer.build(f"({''.join(value + ', ' for value in values)})")


def compile_decoder(definition: Definition) -> Callable[[bytes], Dict[str, Any]]:
    """Write the function that reads a whole message as a dict.

    Args:
        definition: of the messages to be read.

    Returns:
        From bytes to nested builtins; raises TransportError for bytes that do not fit.
    """
    writer = _ReaderText(definition)
    (value,) = writer.walk([()])
    return writer.build(value)


def _check_path(definition: Definition, path: str) -> None:
    spec = definition.root
    steps = path.split("/")
    for depth, step in enumerate(steps):
        found = next((item for item in spec.fields if item.name == step), None)
        if found is None:
            names = ", ".join(item.name for item in spec.fields) or "none"
            raise TransportError(f"{definition.type}: no field {path!r}; fields of {spec.name} are: {names}")
        if depth + 1 < len(steps):
            if found.is_array or found.is_primitive:
                kind = "an array" if found.is_array else f"a {found.type}"
                raise TransportError(
                    f"{definition.type}: no field {path!r}; {found.name} is {kind}, the path must end there"
                )
            spec = definition.specs[found.type]


class _ReaderText:
    """The text of one reader and of the helpers it calls for elements of arrays."""

    def __init__(self, definition: Definition) -> None:
        self._definition = definition
        self._sizes = Sizes(definition)
        self._globals: Dict[str, Any] = {
            "Misfit": struct.error,
            "unpack": struct.unpack_from,
        }
        self._helpers: List[str] = []
        self._known: Dict[Tuple[str, bool], str] = {}
        self._body: List[str] = []

    def walk(self, paths: Sequence[Tuple[str, ...]]) -> List[str]:
        """Write the walk over the whole message; answer one expression per path."""
        walk = _Walk(self, self._globals, self._sizes)
        values = walk.message(self._definition, self._definition.type, (), paths)
        walk.flush()
        self._body = walk.lines
        return [values[path] for path in paths]

    def helper(self, type_name: str, keep: bool) -> str:
        """Write, once, the function that reads or steps over one element of an array of messages."""
        name = self._known.get((type_name, keep))
        if name is None:
            name = self._known[type_name, keep] = f"{'read' if keep else 'skip'}_{len(self._known)}"
            walk = _Walk(self, self._globals, self._sizes)
            values = walk.message(self._definition, type_name, (), [()] if keep else [])
            walk.flush()
            result = f"{values[()]}, pos" if keep else "pos"
            lines = [*walk.lines, f"return {result}"]
            self._helpers.append(f"def {name}(raw, pos, size):\n" + "".join(f"    {line}\n" for line in lines))
        return name

    def build(self, result: str) -> Callable[[bytes], Any]:
        """Compile the text and give the function."""
        # Of what strangers wrote, only names of fields stand in the text, and the grammar admits no code as a name.
        misfit = f"bytes do not fit the definition with md5 {self._definition.md5}"
        self._globals["misfit"] = lambda size: TransportError(f"{self._definition.type}: {size} {misfit}")
        text = "".join(self._helpers) + (
            "def read(raw):\n"
            "    size = len(raw)\n"
            "    pos = 0\n"
            "    try:\n"
            + "".join(f"        {line}\n" for line in self._body)
            + f"        if pos == size:\n            return {result}\n"
            "    except Misfit:\n"
            "        pass\n"
            "    raise misfit(size)\n"
        )
        space = dict(self._globals)
        exec(compile(text, "<reader of messages>", "exec"), space)
        function: Callable[[bytes], Any] = space["read"]
        return function


class _Walk:
    """Lines that step over one message, from ``pos`` on."""

    def __init__(self, text: _ReaderText, space: Dict[str, Any], sizes: Sizes) -> None:
        self.lines: List[str] = []
        self._text = text
        self._space = space
        self._sizes = sizes
        self._codes: List[str] = []
        self._names: List[str] = []
        self._after: List[str] = []
        self._count = 0

    def message(
        self, definition: Definition, type_name: str, above: Tuple[str, ...], wanted: Sequence[Tuple[str, ...]]
    ) -> Dict[Tuple[str, ...], str]:
        """Step over one message.

        Args:
            definition: it belongs to.
            type_name: of the message.
            above: path of the message from the root.
            wanted: absolute paths whose values are needed.

        Returns:
            The expression of each wanted path at or below the message.
        """
        whole = any(path == above[: len(path)] for path in wanted)
        values: Dict[Tuple[str, ...], str] = {}
        parts: List[str] = []
        for item in definition.specs[type_name].fields:
            path = (*above, item.name)
            if not item.is_primitive and not item.is_array:
                found = self.message(definition, item.type, path, wanted)
                values.update(found)
            else:
                keep = whole or path in wanted
                value = self._array(item, keep) if item.is_array else self._primitive(item.type, keep)
                if value is not None:
                    values[path] = value
            if whole:
                parts.append(f"'{item.name}': {values[path]}")
        if whole:
            values[above] = "{" + ", ".join(parts) + "}"
        return values

    def flush(self) -> None:
        """Unpack the numbers gathered so far."""
        if self._codes:
            code = "<" + "".join(self._codes)
            size = struct.calcsize(code)
            if self._names:
                name = f"unpack_{len(self._space)}"
                self._space[name] = struct.Struct(code).unpack_from
                self.lines.append(f"{', '.join(self._names)}, = {name}(raw, pos)")
            self.lines.append(f"pos += {size}")
            self.lines.extend(self._after)
            self._codes, self._names, self._after = [], [], []

    def _name(self) -> str:
        self._count += 1
        return f"v{self._count}"

    def _primitive(self, type_name: str, keep: bool) -> Optional[str]:
        if type_name == "string":
            return self._string(keep)
        if type_name in NUMBERS:
            if keep:
                return self._number(NUMBERS[type_name])
            self._pad(struct.calcsize("<" + NUMBERS[type_name]))
            return None
        if not keep:
            self._pad(8)
            return None
        seconds, nanoseconds, value = self._number(WORDS[type_name][0]), self._number(WORDS[type_name][1]), self._name()
        # Both are integers: Python rounds their quotient once, to the nearest float.
        self._after.append(f"{value} = ({seconds} * {_NANOSECONDS} + {nanoseconds}) / {_NANOSECONDS}")
        return value

    def _number(self, code: str) -> str:
        name = self._name()
        self._codes.append(code)
        self._names.append(name)
        return name

    def _pad(self, size: int) -> None:
        self._codes.append(f"{size}x")

    def _length(self) -> str:
        name = self._number("I")
        self.flush()
        return name

    def _string(self, keep: bool) -> Optional[str]:
        length = self._length()
        value = self._name() if keep else None
        self.lines.append(f"end = pos + {length}")
        self.lines.append("if end > size: raise Misfit")
        if value is not None:
            self.lines.append(f"{value} = {_STRING.format(start='pos')}")
        self.lines.append("pos = end")
        return value

    def _array(self, item: Field, keep: bool) -> Optional[str]:
        least = self._sizes.element(item)
        if (
            item.length is not None
            and not keep
            and self._sizes.is_fixed(item.type)
            and item.length * least < _LONGEST_PAD
        ):
            self._pad(item.length * least)
            return None
        if item.length is None:
            length = self._length()
        else:
            length = str(item.length)
            self.flush()
        if least:
            self.lines.append(f"end = pos + {length} * {least}")
            self.lines.append("if end > size: raise Misfit")
        else:
            self.lines.append("end = pos")
            self.lines.append(f"if {length} > {MOST_EMPTY}: raise Misfit")
        value = self._name() if keep else None
        if self._sizes.is_fixed(item.type) and (value is None or item.is_primitive):
            if value is not None:
                self._fixed_elements(item, length, value)
            self.lines.append("pos = end")
        else:
            self._elements(item, length, value)
        return value

    def _fixed_elements(self, item: Field, length: str, value: str) -> None:
        if item.type in BYTE_TYPES:
            self.lines.append(f"{value} = bytes(raw[pos:end])")
        elif item.type in NUMBERS:
            self.lines.append(f"{value} = list(unpack('<%d{NUMBERS[item.type]}' % {length}, raw, pos))")
        else:
            code = WORDS[item.type][0]
            self.lines.append(f"words = unpack('<%d{code}' % (2 * {length}), raw, pos)")
            self.lines.append(
                f"{value} = [(s * {_NANOSECONDS} + n) / {_NANOSECONDS} for s, n in zip(words[::2], words[1::2])]"
            )

    def _elements(self, item: Field, length: str, value: Optional[str]) -> None:
        if value is not None:
            self.lines.append(f"{value} = []")
        self.lines.append(f"for _ in range({length}):")
        if item.type == "string":
            self._space["unpack_length"] = struct.Struct("<I").unpack_from
            inner = ["end = pos + 4 + unpack_length(raw, pos)[0]", "if end > size: raise Misfit"]
            if value is not None:
                inner.append(f"{value}.append({_STRING.format(start='pos + 4')})")
            inner.append("pos = end")
        elif value is None:
            inner = [f"pos = {self._text.helper(item.type, keep=False)}(raw, pos, size)"]
        else:
            inner = [
                f"element, pos = {self._text.helper(item.type, keep=True)}(raw, pos, size)",
                f"{value}.append(element)",
            ]
        self.lines.extend(f"    {line}" for line in inner)
