"""Topic names with ``@robot_id@`` and ``@task_id@``: what they match and what the tokens stood for."""

from __future__ import annotations

import re
from typing import Dict, Mapping, Optional, Tuple

from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import EVERYTHING
from rqt_mrta_py.model import ROBOT_TOKEN, TASK_TOKEN, resolve_name

__all__ = ["TopicPattern", "resolve_topic"]

_TOKENS: Dict[str, str] = {ROBOT_TOKEN: "robot", TASK_TOKEN: "task"}
_TOKEN = re.compile("|".join(_TOKENS))
_PLACEHOLDER = "X{index}placeholderX"


def resolve_topic(topic: str, node: str, remappings: Optional[Mapping[str, str]] = None) -> str:
    """Resolve the topic of a subscription, which may hold tokens or be EVERYTHING.

    Args:
        topic: as in ``hooks.Subscription``.
        node: resolved name of the node that subscribes.
        remappings: from name to name; names with tokens are not remapped.

    Raises:
        TransportError: ROS would not accept the name.
    """
    if topic == EVERYTHING:
        return topic
    legal = topic
    held: Dict[str, str] = {}
    for index, token in enumerate(_TOKENS):
        placeholder = _PLACEHOLDER.format(index=index)
        if token in legal:
            held[placeholder] = token
            legal = legal.replace(token, placeholder)
    try:
        resolved = resolve_name(legal, node, None if held else remappings)
    except ValueError as error:
        raise TransportError(f"{node}: topic {topic!r}: {error}") from error
    for placeholder, token in held.items():
        resolved = resolved.replace(placeholder, token)
    return resolved


class TopicPattern:
    """A resolved topic, perhaps with tokens, or EVERYTHING.

    Args:
        topic: resolved; a token stands for one or more characters that are no slash, equal wherever it is repeated.

    Attributes:
        topic: as given.
    """

    def __init__(self, topic: str) -> None:
        self.topic = topic
        self._expression: Optional[re.Pattern[str]] = None
        if _TOKEN.search(topic):
            text, end, seen = "", 0, set()
            for token in _TOKEN.finditer(topic):
                name = _TOKENS[token.group()]
                text += re.escape(topic[end : token.start()])
                text += f"(?P={name})" if name in seen else f"(?P<{name}>[^/]+)"
                seen.add(name)
                end = token.end()
            self._expression = re.compile(text + re.escape(topic[end:]) + r"\Z")

    @property
    def is_literal(self) -> bool:
        """Tell whether exactly one topic is meant, the one of this name."""
        return self._expression is None and self.topic != EVERYTHING

    def match(self, topic: str) -> Optional[Tuple[str, str]]:
        """Tell whether a topic is meant.

        Args:
            topic: resolved.

        Returns:
            What ``@robot_id@`` and ``@task_id@`` stand for, empty where there is no such token; None if the topic
            is not meant.
        """
        if self._expression is None:
            return ("", "") if self.topic in (topic, EVERYTHING) else None
        found = self._expression.match(topic)
        if found is None:
            return None
        groups = found.groupdict()
        return groups.get("robot", ""), groups.get("task", "")
