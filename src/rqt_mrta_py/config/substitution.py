"""Tokens such as ``@robot_id@`` in templates: in parameters (names, values, defaults) and in launch files."""

from __future__ import annotations

import re
from typing import Mapping

from rqt_mrta_py.model import ROBOT_TOKEN, TASK_TOKEN

__all__ = ["INDEX_TOKEN", "PACKAGE_TOKEN", "SIZE_TOKEN", "has_token", "substitute"]

INDEX_TOKEN = "@index@"
"""Stands for the index of an element, from 0."""

SIZE_TOKEN = "@array_size@"
"""Stands for the number of elements."""

PACKAGE_TOKEN = "@package@"
"""Stands for the name of the application's package."""

_TOKEN = re.compile("|".join((ROBOT_TOKEN, TASK_TOKEN, INDEX_TOKEN, SIZE_TOKEN, PACKAGE_TOKEN)))


def has_token(text: str) -> bool:
    """Tell whether a text holds a token that is substituted later, so that its type cannot be judged yet."""
    return "@" in text and _TOKEN.search(text) is not None


def substitute(text: str, values: Mapping[str, str]) -> str:
    """Put values in the place of tokens, in one pass: what a value holds is not substituted again.

    Args:
        text: of a template.
        values: by token, such as ``{ROBOT_TOKEN: "robot1", PACKAGE_TOKEN: "yard"}``.

    Returns:
        The text; tokens without a value, and anything else between two ``@``, stand as they were.
    """
    if "@" not in text:
        return text
    return _TOKEN.sub(lambda match: values.get(match.group(), match.group()), text)
