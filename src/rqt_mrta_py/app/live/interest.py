"""Which topics of a live graph a supervisor hears."""

from __future__ import annotations

from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import Collection, List, Sequence, Tuple

from rqt_mrta_py.app.run.watch import SUPERVISOR_TOPICS
from rqt_mrta_py.hooks import EVERYTHING, Subscription
from rqt_mrta_py.transport.patterns import TopicPattern

__all__ = ["HEAVY_TYPES", "Interest", "TopicChoice"]

HEAVY_TYPES = frozenset(
    (
        "sensor_msgs/CompressedImage",
        "sensor_msgs/Image",
        "sensor_msgs/PointCloud",
        "sensor_msgs/PointCloud2",
        "stereo_msgs/DisparityImage",
        "theora_image_transport/Packet",
    )
)
"""Images and point clouds: a robot says megabytes of them a second, and nobody here looks at them."""

_OWN = frozenset((*SUPERVISOR_TOPICS, "/diagnostics", "/rosout_agg"))
"""What a supervisor says itself, or what is about nodes rather than robots."""


@dataclass(frozen=True)
class TopicChoice:
    """Patterns of topics, as people write them.

    Attributes:
        named: topics wanted, with ``*`` for anything, slashes too, and ``?`` for one character.
        left_out: topics not wanted, whoever names them.
    """

    named: Tuple[str, ...] = ()
    left_out: Tuple[str, ...] = ()

    @classmethod
    def of(cls, patterns: Sequence[str]) -> TopicChoice:
        """Read patterns; those that begin with ``!`` leave topics out. A slash in front need not be written."""
        named: List[str] = []
        left_out: List[str] = []
        for pattern in patterns:
            (left_out if pattern.startswith("!") else named).append(_rooted(pattern.lstrip("!")))
        return cls(tuple(named), tuple(left_out))

    def names(self, topic: str) -> bool:
        """Tell whether a topic is named."""
        return any(fnmatchcase(topic, pattern) for pattern in self.named)

    def leaves_out(self, topic: str) -> bool:
        """Tell whether a topic is left out."""
        return any(fnmatchcase(topic, pattern) for pattern in self.left_out)

    def keeps(self, topic: str) -> bool:
        """Tell whether a topic is one of those named, of all if none is, and not left out."""
        return (not self.named or self.names(topic)) and not self.leaves_out(topic)


class Interest:
    """Decides topic by topic.

    Heard is what the observation of the mission subscribes to, and everything in the namespaces of its robots but
    images and point clouds, and whatever the choice names.

    Args:
        wishes: what is subscribed to; EVERYTHING means everything that is heard anyway.
        choice: the user's.
    """

    def __init__(self, wishes: Sequence[Subscription], choice: TopicChoice) -> None:
        topics = dict.fromkeys(wish.topic for wish in wishes if wish.topic != EVERYTHING)
        self._patterns = [TopicPattern(topic) for topic in topics]
        self._asked_for = frozenset(pattern.topic for pattern in self._patterns if pattern.is_literal)
        self._choice = choice

    def wants(self, topic: str, type_name: str, robots: Collection[str]) -> bool:
        """Tell whether a topic is heard.

        Args:
            topic: resolved.
            type_name: ``pkg/Msg``; empty if unknown.
            robots: ids of the robots that are known.
        """
        if self._choice.leaves_out(topic):
            return False
        if self._choice.names(topic) or topic in self._asked_for:
            return True
        if topic in _OWN or type_name in HEAVY_TYPES:
            return False
        return _in_namespace(topic, robots) or any(pattern.match(topic) is not None for pattern in self._patterns)


def _in_namespace(topic: str, robots: Collection[str]) -> bool:
    """Tell whether a topic lies in the namespace of a robot, whose id may hold slashes."""
    namespace = topic[1:]
    while "/" in namespace:
        namespace = namespace.rsplit("/", 1)[0]
        if namespace in robots:
            return True
    return False


def _rooted(pattern: str) -> str:
    return pattern if pattern.startswith(("/", "*")) else f"/{pattern}"
