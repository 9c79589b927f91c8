"""The text of a launch file, as the original lays it out."""

from __future__ import annotations

from typing import List, Mapping, Sequence, Tuple
from xml.sax.saxutils import escape

from rqt_mrta_py.config.generated.marks import MARK

__all__ = ["Include", "launch_text"]

Include = Tuple[str, Mapping[str, str]]
"""The file that is included, and the values of its arguments in order."""


def launch_text(includes: Sequence[Include]) -> str:
    """Write a launch file that includes others, marked as generated.

    Args:
        includes: in order; values may hold roslaunch's own ``$(find ...)``.

    Returns:
        XML, indented by tabs, ending in a line break.
    """
    lines: List[str] = ['<?xml version="1.0"?>', f"<!-- {MARK} -->", "<launch>"]
    for file, arguments in includes:
        if not arguments:
            lines.append(f"\t<include file={_quoted(file)} />")
            continue
        lines.append(f"\t<include file={_quoted(file)}>")
        lines.extend(f"\t\t<arg name={_quoted(name)} value={_quoted(value)} />" for name, value in arguments.items())
        lines.append("\t</include>")
    return "\n".join([*lines, "</launch>", ""])


def _quoted(text: str) -> str:
    return f'"{escape(text, {chr(34): "&quot;"})}"'
