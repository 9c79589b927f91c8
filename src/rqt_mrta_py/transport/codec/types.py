"""Message types by name: the standard ones from rosbags' Noetic store, all others from ``.msg`` texts.

The standard types never come from an installed ROS: its texts carry comments that differ between distributions, and
a bag must be the same with and without ROS.
"""

from __future__ import annotations

from typing import Callable, Dict, Optional

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.transport.codec.definitions import Definition, MessageSpec, parse_definition, parse_message
from rqt_mrta_py.transport.rosbags_door import noetic_definition

__all__ = ["TypeLibrary"]

_BEYOND_THE_STORE = {"tf2_msgs/TFMessage": "geometry_msgs/TransformStamped[] transforms\n"}
"""Standard types that rosbags does not know."""


class TypeLibrary:
    """Finds definitions of message types and keeps them.

    Args:
        lookup: from ``pkg/Msg`` to the text of its ``.msg`` file; None where there is none. May raise OSError, or
            ValueError where the file is no text.
    """

    def __init__(self, lookup: Callable[[str], Optional[str]]) -> None:
        self._lookup = lookup
        self._specs: Dict[str, MessageSpec] = {}
        self._definitions: Dict[str, Definition] = {}

    def definition(self, type_name: str) -> Definition:
        """Find a type and all types that it contains.

        Args:
            type_name: ``pkg/Msg``.

        Raises:
            TransportError: the type, or one that it contains, is not known or its text cannot be read or understood.
        """
        found = self._definitions.get(type_name)
        if found is None:
            found = self._definitions[type_name] = Definition.gather(type_name, self._spec)
        return found

    def _spec(self, name: str) -> MessageSpec:
        if name not in self._specs:
            self._specs[name] = self._load(name)
        return self._specs[name]

    def _load(self, name: str) -> MessageSpec:
        if name in _BEYOND_THE_STORE:
            return parse_message(name, _BEYOND_THE_STORE[name])
        standard = noetic_definition(name)
        if standard is not None:
            return parse_definition(name, standard).root
        try:
            text = self._lookup(name)
        except (OSError, ValueError) as error:
            raise TransportError(f"message type {name!r}: its definition cannot be read: {error}") from error
        if text is None:
            package, _, message = name.partition("/")
            raise TransportError(
                f"message type {name!r} is not known: it is no standard type, and no package on the search path has "
                f"{package}/msg/{message or '<Msg>'}.msg"
            )
        return parse_message(name, text)
