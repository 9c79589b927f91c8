"""From YAML text to values that know their line: safe types only, no bombs, no key twice.

PyYAML's event stream is composed here, not by PyYAML: composing there is recursive, follows aliases without end, and
lets the last of two equal keys win in silence.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple, Union

import yaml

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.wording import shown

__all__ = ["YamlNode", "parse_yaml"]

_DEEPEST = 50
_LARGEST = 100_000
_SAFE_TAGS = frozenset(f"tag:yaml.org,2002:{name}" for name in ("null", "bool", "int", "float", "str"))
_TEXT_TAG = "tag:yaml.org,2002:str"
_TIMESTAMP_TAG = "tag:yaml.org,2002:timestamp"


@dataclass(frozen=True)
class YamlNode:
    """One value of a YAML document.

    Attributes:
        value: None, bool, int, float or str; a tuple of nodes; or nodes by key, in file order.
        line: 1-based line on which it begins.
        lines: of the keys, where the value is a mapping.
        size: number of scalars and collections in it, itself included.
    """

    value: Union[bool, int, float, str, Tuple[YamlNode, ...], Dict[str, YamlNode], None]
    line: int
    lines: Dict[str, int]
    size: int

    def plain(self) -> Any:
        """Give the value as nested builtins, sequences as lists."""
        if isinstance(self.value, dict):
            return {key: node.plain() for key, node in self.value.items()}
        if isinstance(self.value, tuple):
            return [node.plain() for node in self.value]
        return self.value


class _Frame:
    """A collection that is being composed."""

    def __init__(self, line: int, anchor: Optional[str], mapping: bool) -> None:
        self.line = line
        self.anchor = anchor
        self.mapping = mapping
        self.items: List[YamlNode] = []
        self.nodes: Dict[str, YamlNode] = {}
        self.lines: Dict[str, int] = {}
        self.key: Optional[YamlNode] = None

    def close(self) -> YamlNode:
        parts = list(self.nodes.values()) if self.mapping else self.items
        value: Union[Tuple[YamlNode, ...], Dict[str, YamlNode]] = self.nodes if self.mapping else tuple(self.items)
        return YamlNode(value, self.line, self.lines, 1 + sum(part.size for part in parts))


def parse_yaml(text: Union[str, bytes], path: str) -> Optional[YamlNode]:
    """Parse one YAML document.

    Args:
        text: the document; bytes are UTF-8.
        path: by which problems name it.

    Returns:
        The value; None where the document is empty.

    Raises:
        ConfigError: it is not YAML, or holds what is not accepted: a key twice, a key that is no text, tags, numbers
            that are not finite, more than one document, or more than a configuration can sensibly hold.
    """
    problems = Problems(path)
    try:
        composed = _Composer(text if isinstance(text, str) else text.decode("utf-8"), problems).compose()
    except (yaml.YAMLError, ValueError, OverflowError, IndexError) as error:
        raise ConfigError([*problems.found, Problem(path, *_place_and_cause(error, text))]) from error
    problems.raise_if_any()
    return composed


def _place_and_cause(error: Exception, text: Union[str, bytes]) -> Tuple[int, str, str]:
    """Give line, element and message of what the YAML library could not read."""
    if isinstance(error, UnicodeDecodeError):
        return error.object.count(b"\n", 0, error.start) + 1, "", "is not UTF-8 text"
    if isinstance(error, yaml.MarkedYAMLError):
        mark = error.problem_mark or error.context_mark
        return (mark.line + 1 if mark is not None else 0), "", f"is not YAML: {error.problem or error.context}"
    if isinstance(error, yaml.reader.ReaderError):
        whole = text if isinstance(text, str) else text.decode("utf-8")
        character = shown(chr(error.character))
        return whole.count("\n", 0, error.position) + 1, "", f"is not YAML: the character {character} is not allowed"
    return 0, "", f"is not YAML: {error}"


class _Composer:
    """Builds nodes from events, without recursion."""

    def __init__(self, text: str, problems: Problems) -> None:
        # types-PyYAML leaves the loader's parser and resolver without annotations.
        self._loader: Any = yaml.SafeLoader(text)
        self._problems = problems
        self._frames: List[_Frame] = []
        self._anchors: Dict[str, YamlNode] = {}
        self._root: Optional[YamlNode] = None
        self._documents = 0

    def compose(self) -> Optional[YamlNode]:
        try:
            while self._loader.check_event():
                self._take(self._loader.get_event())
        finally:
            self._loader.dispose()
        return self._root

    def _take(self, event: Any) -> None:
        line = event.start_mark.line + 1
        if isinstance(event, yaml.DocumentStartEvent):
            self._documents += 1
            if self._documents > 1:
                self._stop(line, "begins a second document; one is expected")
        elif isinstance(event, (yaml.MappingStartEvent, yaml.SequenceStartEvent)):
            if event.tag is not None:
                self._stop(line, f"carries the tag {shown(event.tag)}; tags are not accepted")
            if len(self._frames) >= _DEEPEST:
                self._stop(line, f"is nested deeper than {_DEEPEST} levels")
            self._frames.append(_Frame(line, event.anchor, isinstance(event, yaml.MappingStartEvent)))
        elif isinstance(event, (yaml.MappingEndEvent, yaml.SequenceEndEvent)):
            frame = self._frames.pop()
            self._put(frame.close(), frame.anchor)
        elif isinstance(event, yaml.ScalarEvent):
            self._put(YamlNode(self._scalar(event, line), line, {}, 1), event.anchor)
        elif isinstance(event, yaml.AliasEvent):
            anchor = str(event.anchor)
            if anchor not in self._anchors:
                self._stop(line, f"refers to {shown(anchor)}, which is not complete here")
            self._put(self._anchors[anchor], None)

    def _put(self, node: YamlNode, anchor: Optional[str]) -> None:
        if node.size > _LARGEST:
            self._stop(node.line, f"holds more than {_LARGEST} values")
        if anchor is not None:
            self._anchors[anchor] = node
        if not self._frames:
            self._root = node if node.value is not None else None
            return
        frame = self._frames[-1]
        if not frame.mapping:
            frame.items.append(node)
        elif frame.key is None:
            if not isinstance(node.value, str):
                self._stop(node.line, f"has the key {shown(node.plain())}; keys are texts: put it in quotes")
            frame.key = node
        else:
            key, frame.key = frame.key, None
            name = str(key.value)
            if name in frame.nodes:
                self._problems.add(key.line, name, f"stands twice; the first one is in line {frame.lines[name]}")
                return
            frame.nodes[name] = node
            frame.lines[name] = key.line

    def _scalar(self, event: Any, line: int) -> Union[bool, int, float, str, None]:
        tag = event.tag
        if tag is None or tag == "!":
            tag = self._loader.resolve(yaml.ScalarNode, event.value, event.implicit)
        if tag == _TIMESTAMP_TAG or tag not in _SAFE_TAGS:
            if event.tag is not None:
                self._stop(line, f"carries the tag {shown(event.tag)}; tags are not accepted")
            tag = _TEXT_TAG
        node = yaml.ScalarNode(tag, event.value, event.start_mark, event.end_mark)
        try:
            value = self._loader.construct_object(node)
        except (ValueError, KeyError, OverflowError, IndexError):
            self._stop(line, f"is not a number ({shown(event.value)})")
        if isinstance(value, float) and not math.isfinite(value):
            self._problems.add(line, "", f"holds {event.value}; numbers must be finite")
            return 0.0
        if isinstance(value, str) and any("\ud800" <= character <= "\udfff" for character in value):
            self._stop(line, f"holds half a character ({shown(value)})")
        return value if isinstance(value, (bool, int, float, str)) else None

    def _stop(self, line: int, message: str) -> None:
        """Note a problem after which going on makes no sense."""
        self._problems.add(line, "", message)
        self._problems.raise_if_any()
        raise ConfigError(self._problems.found)
