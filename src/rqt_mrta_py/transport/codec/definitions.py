"""Message definitions: the texts of ``.msg`` files and connections, what they declare, and their md5.

The grammar is genmsg's, line by line: a field is ``type name``, a constant ``type NAME=value``, ``#`` begins a
comment save in the value of a string constant. A definition's full text is the type's own text, then for every type
it contains a line of 80 ``=``, ``MSG: pkg/Msg`` and that type's text, each once, depth first.
"""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass, field
from typing import Callable, Dict, List, Mapping, Optional, Set, Tuple

from rqt_mrta_py.errors import TransportError

__all__ = [
    "HEADER",
    "PRIMITIVES",
    "Constant",
    "Definition",
    "Field",
    "MessageSpec",
    "parse_definition",
    "parse_message",
]

HEADER = "std_msgs/Header"

PRIMITIVES = frozenset(
    ("bool", "byte", "char", "duration", "float32", "float64", "int16", "int32", "int64", "int8", "string", "time")
    + ("uint16", "uint32", "uint64", "uint8")
)

_SEPARATOR = re.compile(r"^={80}[ \t\r]*\nMSG:[ \t]*(\S+)[ \t\r]*$", re.MULTILINE)
_TYPE = re.compile(r"([A-Za-z]\w*(?:/[A-Za-z]\w*)?)(\[(\d{0,10})\])?\Z", re.ASCII)
_NAME = re.compile(r"[A-Za-z]\w*\Z", re.ASCII)
_DEEPEST = 32
"""How deep messages may contain one another; the deepest known types reach 7."""


@dataclass(frozen=True)
class Constant:
    """A named value that belongs to a type and never travels; ``text`` is the value as written."""

    type: str
    name: str
    text: str


@dataclass(frozen=True)
class Field:
    """One field of a message.

    Attributes:
        type: a primitive, or ``pkg/Msg``; of one element if the field is an array.
        name: of the field.
        is_array: True for both forms of array.
        length: of an array of fixed length; None for any other field.
    """

    type: str
    name: str
    is_array: bool = False
    length: Optional[int] = None

    @property
    def is_primitive(self) -> bool:
        """Tell whether the type (of one element) is built into ROS."""
        return self.type in PRIMITIVES


@dataclass(frozen=True)
class MessageSpec:
    """What the text of one type declares.

    Attributes:
        name: ``pkg/Msg``.
        fields: in the order of the wire.
        constants: in the order of the text.
        text: the ``.msg`` file.
    """

    name: str
    fields: Tuple[Field, ...]
    constants: Tuple[Constant, ...]
    text: str = field(repr=False)


@dataclass(frozen=True)
class Definition:
    """A type with all types that it contains.

    Attributes:
        type: ``pkg/Msg``.
        specs: by name, of the type and of all it contains, depth first.
    """

    type: str
    specs: Mapping[str, MessageSpec] = field(repr=False)

    @classmethod
    def gather(cls, type_name: str, lookup: Callable[[str], MessageSpec]) -> Definition:
        """Collect a type and everything it contains.

        Args:
            type_name: ``pkg/Msg``.
            lookup: from a type's name to what it declares; raises TransportError where it is not known.

        Raises:
            TransportError: a type is not known, contains itself, or the nesting has no reasonable end.
        """
        specs: Dict[str, MessageSpec] = {}

        def visit(name: str, above: Tuple[str, ...]) -> None:
            if name in above:
                raise TransportError(f"{type_name}: {name} contains itself; a message must have an end")
            if len(above) > _DEEPEST:
                raise TransportError(f"{type_name}: messages nest deeper than {_DEEPEST} at {name}")
            if name in specs:
                return
            specs[name] = lookup(name)
            for item in specs[name].fields:
                if not item.is_primitive:
                    visit(item.type, (*above, name))

        visit(type_name, ())
        definition = cls(type_name, specs)
        definition._check_depth()
        return definition

    @property
    def root(self) -> MessageSpec:
        """Give what the type itself declares."""
        return self.specs[self.type]

    @property
    def begins_with_header(self) -> bool:
        """Tell whether the first field is a std_msgs/Header, whose ``seq`` publishers count."""
        return bool(self.root.fields) and self.root.fields[0].type == HEADER and not self.root.fields[0].is_array

    @property
    def md5(self) -> str:
        """Compute the md5 as ROS does: comments, order of constants and names of contained types do not matter."""
        return hashlib.md5(self.md5_text.encode()).hexdigest()

    @property
    def md5_text(self) -> str:
        """Write down what the md5 is taken of; that of a service is taken of both its parts, one after the other."""
        known: Dict[str, str] = {}
        text = ""
        for name in self.contained_first:
            spec = self.specs[name]
            lines = [f"{constant.type} {constant.name}={constant.text}" for constant in spec.constants]
            for item in spec.fields:
                brackets = "" if not item.is_array else "[]" if item.length is None else f"[{item.length}]"
                lines.append(
                    f"{item.type}{brackets} {item.name}" if item.is_primitive else f"{known[item.type]} {item.name}"
                )
            text = "\n".join(lines).strip()
            known[name] = hashlib.md5(text.encode()).hexdigest()
        return text

    @property
    def full_text(self) -> str:
        """Join the texts of all types as ROS does."""
        parts = [self.root.text + "\n"]
        for name, spec in self.specs.items():
            if name != self.type:
                parts.append(f"{'=' * 80}\nMSG: {name}\n{spec.text}\n")
        return "".join(parts)[:-1]

    @property
    def contained_first(self) -> Tuple[str, ...]:
        """List all types so that each stands after those it contains."""
        done: Dict[str, None] = {}

        def visit(name: str) -> None:
            if name not in done:
                for item in self.specs[name].fields:
                    if not item.is_primitive:
                        visit(item.type)
                done[name] = None

        visit(self.type)
        return tuple(done)

    def _check_depth(self) -> None:
        # Types first met on a short way may also stand at the end of a too long one.
        depth: Dict[str, int] = {}
        for name in self.contained_first:
            below = [depth[item.type] for item in self.specs[name].fields if not item.is_primitive]
            depth[name] = 1 + max(below, default=0)
        if depth[self.type] > _DEEPEST:
            raise TransportError(f"{self.type}: messages nest {depth[self.type]} deep; at most {_DEEPEST} are accepted")


def parse_message(name: str, text: str) -> MessageSpec:
    """Read the text of one type.

    Args:
        name: ``pkg/Msg``.
        text: of its ``.msg`` file.

    Raises:
        TransportError: a line is neither field nor constant, or a name occurs twice; names type and line.
    """
    package = name.partition("/")[0]
    fields: List[Field] = []
    constants: List[Constant] = []
    for number, line in enumerate(text.split("\n"), start=1):
        clean = line.split("#")[0].strip()
        if not clean:
            continue
        where = f"{name}, line {number} of its definition"
        if "=" in clean:
            constants.append(_constant(where, line, clean))
        else:
            fields.append(_field(where, clean, package))
    declared: Set[str] = set()
    for item in fields:
        if item.name in declared:
            raise TransportError(f"{name}: field {item.name!r} is declared twice; names of fields must differ")
        declared.add(item.name)
    return MessageSpec(name, tuple(fields), tuple(constants), text)


def parse_definition(type_name: str, full_text: str) -> Definition:
    """Read a definition as it travels with a connection.

    Args:
        type_name: ``pkg/Msg`` of the first text.
        full_text: texts of the type and of all it contains.

    Raises:
        TransportError: the text cannot be understood or lacks a type; names the type and what is wrong.
    """
    parts = _SEPARATOR.split(full_text)
    specs = {type_name: parse_message(type_name, parts[0])}
    for name, text in zip(parts[1::2], parts[2::2]):
        # The separator swallowed the line break after MSG; genmsg's texts have it not.
        specs.setdefault(name, parse_message(name, text[1:] if text.startswith("\n") else text))

    def lookup(name: str) -> MessageSpec:
        try:
            return specs[name]
        except KeyError:
            raise TransportError(f"{type_name}: its definition lacks the text of {name}, which it contains") from None

    return Definition.gather(type_name, lookup)


def _constant(where: str, line: str, clean: str) -> Constant:
    type_name, _, rest = clean.replace("\t", " ").partition(" ")
    if type_name not in PRIMITIVES - {"time", "duration"}:
        raise TransportError(f"{where}: {type_name!r} cannot be the type of a constant; accepted are ROS's own types")
    # A string's value goes to the end of the line and may hold any character, # and = included.
    declared, _, value = (line.strip() if type_name == "string" else clean).partition("=")
    name = (
        declared.replace("\t", " ").partition(" ")[2].strip()
        if type_name == "string"
        else rest.partition("=")[0].strip()
    )
    if not _NAME.match(name):
        raise TransportError(f"{where}: {name!r} cannot be the name of a constant; accepted are letters, digits and _")
    return Constant(type_name, name, value.strip())


def _field(where: str, clean: str, package: str) -> Field:
    words = clean.split()
    match = _TYPE.match(words[0])
    if len(words) != 2 or match is None or not _NAME.match(words[1]):
        raise TransportError(f"{where}: {clean!r} is no declaration; accepted is 'type name' or 'type NAME=value'")
    base, array, length = match.group(1), match.group(2), match.group(3)
    if base == "Header":
        base = HEADER
    elif base not in PRIMITIVES and "/" not in base:
        base = f"{package}/{base}"
    return Field(base, words[1], array is not None, int(length) if length else None)
