"""Writers of messages of one form: the same fields given and the same left out, as a publisher says again and again.

Such a writer asks for exactly those fields and knows where the others' zeros stand, so it takes less than half the
time. What it is not made for it hands on, in the end to the writer of messages of any form.
"""

from __future__ import annotations

from typing import Any, List, Mapping, Tuple

from rqt_mrta_py.transport.codec.definitions import Definition, Field
from rqt_mrta_py.transport.codec.encoder_text import Encoder, EncoderText
from rqt_mrta_py.transport.codec.writing import Walk, compile_encoder

__all__ = ["FormedEncoder"]

_OFTEN = 8
"""After so many messages of no known form, that of the last is learned."""
_MOST_FORMS = 2
"""What is of neither has been tried by both; more forms would make that slow."""


class FormedEncoder:
    """Serialises messages of one type; learns their forms as they come.

    Attributes:
        write: from nested fields to bytes; raises TransportError naming type and path for what does not fit. It
            changes with every form that is learned.

    Args:
        definition: of the type.
    """

    def __init__(self, definition: Definition) -> None:
        self.write: Encoder = self._write_any
        self._definition = definition
        self._plain = compile_encoder(definition)
        self._unknown = 0
        self._forms = 0

    def _write_any(self, fields: Mapping[str, Any]) -> bytes:
        raw = self._plain(fields)
        if self._forms < _MOST_FORMS:
            self._unknown += 1
            if self._unknown == _OFTEN:
                self._learn(fields)
        return raw

    def _learn(self, fields: Mapping[str, Any]) -> None:
        self._unknown = 0
        self._forms += 1
        text = EncoderText(self._definition, self.write)
        try:
            walk = _FormWalk(text, fields)
            walk.message(self._definition.type, "f")
        except _NoFormError:
            return
        self.write = text.function(walk.written())


class _NoFormError(Exception):
    """A message has no form that others are likely to have."""


class _FormWalk(Walk):
    """Lines that take messages apart that give the fields that one message gives, and no others.

    Args:
        text: of the encoder.
        form: the message.
    """

    def __init__(self, text: EncoderText, form: Mapping[str, Any]) -> None:
        super().__init__(text)
        self._form = form

    def message(self, type_name: str, source: str) -> List[Tuple[str, str]]:
        """Take apart one message, which the variable ``source`` holds; no part of it is ever left out."""
        form = self._form
        if form.__class__ is not dict:
            raise _NoFormError
        # As many fields as the form, and each of its fields: those and no others. Other mappings may make up fields.
        self.line(f"if {source}.__class__ is not dict or len({source}) != {len(form)}: raise Misfit")
        for item in self.text.definition.specs[type_name].fields:
            if item.name not in form:
                self._leave_out(item)
            elif item.is_array or not item.is_primitive:
                name = self.name()
                self.line(f"{name} = {self.asked(item, source, '')}")
                if item.is_array:
                    self.elements(item, name)
                    self.chunk(name)
                else:
                    self._form = form[item.name]
                    self.message(item.type, name)
                    self._form = form
            else:
                self.primitive(item, source)
        return []

    def asked(self, item: Field, source: str, zero: str) -> str:
        """Give the text that asks a message for a field that it must have."""
        return f"{source}['{item.name}']"

    def writer(self, item: Field) -> str:
        """Write the helper for messages of an array that are like the first of them, and name it."""
        elements = self._form[item.name]
        if not elements or any(element.keys() != elements[0].keys() for element in elements):
            raise _NoFormError
        walk = _FormWalk(self.text, elements[0])
        walk.message(item.type, "f")
        return self.text.helper(walk.written())

    def _leave_out(self, item: Field) -> None:
        size = self.text.sizes.element(item)
        if item.is_array:
            size = 4 if item.length is None else size * item.length
        self.pack(f"{size}x")
