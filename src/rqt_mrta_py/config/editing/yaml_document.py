"""A YAML document that is edited in place: only the characters of what changes are replaced.

Positions come from PyYAML, which reads the file as everybody else here does; a library that writes documents anew
would lay out by its own taste what somebody laid out by hand.
"""

from __future__ import annotations

from typing import Any, List, Mapping, Optional

import yaml

from rqt_mrta_py.config.yaml.text import parse_yaml

__all__ = ["YamlDocument"]


class YamlDocument:
    """The text of a YAML file whose top is a mapping of lists of mappings.

    Args:
        text: the whole file.
        path: by which problems name it.

    Raises:
        ConfigError: it is not YAML that is accepted here.
    """

    def __init__(self, text: str, path: str) -> None:
        parse_yaml(text, path)
        self.text = text
        self.path = path

    def entries(self, key: str) -> List[yaml.MappingNode]:
        """Give the mappings of the list under a key; none where there is no such list."""
        holder = self._list(key)
        return [node for node in holder.value if isinstance(node, yaml.MappingNode)] if holder is not None else []

    def replace(self, nodes: List[yaml.ScalarNode], text: str) -> None:
        """Put a text in the place of some scalars of the document as it is now."""
        for node in sorted(nodes, key=lambda each: each.start_mark.index, reverse=True):
            self._splice(node.start_mark.index, node.end_mark.index, _flow(text))

    def remove_entry(self, key: str, index: int) -> None:
        """Take one entry out of the list under a key, with its line where it has one of its own."""
        holder = self._list(key)
        if holder is None:
            raise ValueError(f"{key} is no list")
        items = holder.value
        if holder.flow_style:
            start, end = items[index].start_mark.index, _end(items[index])
            if index + 1 < len(items):
                end = items[index + 1].start_mark.index
            elif index:
                start = _end(items[index - 1])
            self._splice(start, end, "")
            return
        dash = self._dash(items[index])
        start = self.text.rfind("\n", 0, dash) + 1
        end = self._line_end(_end(items[index]))
        if len(items) == 1:
            self._splice(start, end, "")
            colon = self.text.index(":", self._key(key).end_mark.index)
            self._splice(colon + 1, colon + 1, " []")
        else:
            self._splice(start, end, "")

    def append_entry(self, key: str, values: Mapping[str, Any]) -> None:
        """Add an entry to the list under a key, laid out as the one before it."""
        holder = self._list(key)
        if holder is None:
            raise ValueError(f"{key} is no list")
        items = holder.value
        if holder.flow_style:
            if not items:
                self._splice(holder.start_mark.index, holder.end_mark.index, f"[{_flow(values)}]")
                return
            end, start = _end(items[-1]), items[-1].start_mark
            own_line = len(items) > 1 and start.line > items[-2].start_mark.line
            self._splice(end, end, f",\n{' ' * start.column}{_flow(values)}" if own_line else f", {_flow(values)}")
            return
        dash = self._dash(items[-1])
        indent = " " * (dash - self.text.rfind("\n", 0, dash) - 1)
        if items[-1].flow_style:
            entry = _flow(values)
        else:
            block = yaml.safe_dump(values, sort_keys=False, default_flow_style=None, width=1_000_000)
            entry = f"\n{indent}  ".join(block.rstrip("\n").split("\n"))
        end = self._line_end(_end(items[-1]))
        gap = "" if self.text[:end].endswith("\n") else "\n"
        self._splice(end, end, f"{gap}{indent}- {entry}\n")

    def _list(self, key: str) -> Optional[yaml.SequenceNode]:
        top = yaml.compose(self.text, Loader=yaml.SafeLoader)
        for name, value in top.value if isinstance(top, yaml.MappingNode) else ():
            if name.value == key and isinstance(value, yaml.SequenceNode):
                return value
        return None

    def _key(self, key: str) -> yaml.ScalarNode:
        top: Any = yaml.compose(self.text, Loader=yaml.SafeLoader)
        found: yaml.ScalarNode = next(name for name, _ in top.value if name.value == key)
        return found

    def _dash(self, item: yaml.Node) -> int:
        """Find the dash before an entry of a block list."""
        dashes: List[int] = [
            token.start_mark.index
            for token in yaml.scan(self.text, Loader=yaml.SafeLoader)
            if isinstance(token, yaml.BlockEntryToken)
        ]
        return max(index for index in dashes if index < item.start_mark.index)

    def _line_end(self, index: int) -> int:
        """Give the index after the end of a line."""
        end = self.text.find("\n", index)
        return len(self.text) if end < 0 else end + 1

    def _splice(self, start: int, end: int, text: str) -> None:
        if "\r\n" in self.text:
            text = text.replace("\n", "\r\n")
        self.text = f"{self.text[:start]}{text}{self.text[end:]}"


def _end(node: yaml.Node) -> int:
    """Give where a node's own text ends; a block collection's mark lies behind the comments that follow it."""
    while isinstance(node, yaml.CollectionNode) and not node.flow_style and node.value:
        last = node.value[-1]
        node = last[1] if isinstance(last, tuple) else last
    return int(node.end_mark.index)


def _flow(value: Any) -> str:
    """Write a value in one line, as it may stand within brackets."""
    text: str = yaml.safe_dump([value], sort_keys=False, default_flow_style=True, width=1_000_000)
    return text.strip()[1:-1]
