"""The text of a writer of messages, and what it needs at hand when it runs."""

from __future__ import annotations

import struct
from functools import lru_cache
from typing import Any, Callable, Dict, List, Mapping, Sequence

from rqt_mrta_py.transport.codec.definitions import Definition
from rqt_mrta_py.transport.codec.values import Texts, bytes_of, elements_of, truth_of, truths_of, words_of
from rqt_mrta_py.transport.codec.wire import Sizes, duration_words, time_words

__all__ = ["Encoder", "EncoderText"]

Encoder = Callable[[Mapping[str, Any]], bytes]
"""From nested fields to bytes."""

_FAULTS = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError, struct.error)
"""What Python raises for values that do not fit."""


class EncoderText:
    """The text of one encoder and of the helpers it calls for elements of arrays.

    Attributes:
        definition: of the type.
        sizes: of what it contains.
        known: names of the helpers that write messages of any form, by type.

    Args:
        definition: of the type.
        otherwise: writes, or refuses, messages whose values do not fit; called while what Python raised is handled.
    """

    def __init__(self, definition: Definition, otherwise: Encoder) -> None:
        self.definition = definition
        self.sizes = Sizes(definition)
        self._space: Dict[str, Any] = {
            "MISSING": object(),
            "ZERO": b"\0",
            "Misfit": ValueError,
            "FAULTS": _FAULTS,
            "otherwise": otherwise,
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
        self.known: Dict[str, str] = {}
        self._helpers: List[str] = []

    def function(self, lines: Sequence[str]) -> Encoder:
        """Compile the text, with the lines that write a whole message ``f``, and give the function."""
        text = "".join(self._helpers) + (
            "def write(f):\n    try:\n"
            + "".join(f"        {line}\n" for line in lines)
            + "    except FAULTS:\n        return otherwise(f)\n"
        )
        exec(compile(text, "<encoder of messages>", "exec"), self._space)
        function: Encoder = self._space["write"]
        return function

    def constant(self, prefix: str, value: Any) -> str:
        """Name a value that the text refers to."""
        name = f"{prefix}_{len(self._space)}"
        self._space[name] = value
        return name

    def helper(self, lines: Sequence[str]) -> str:
        """Add a function of the lines that write a contained message ``f``, and name it."""
        name = f"write_{len(self._helpers)}"
        self._helpers.append(f"def {name}(f):\n" + "".join(f"    {line}\n" for line in lines))
        return name
