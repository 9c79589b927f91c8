"""Tokens such as ``@robot_id@`` in templates: in parameters (names, values, defaults) and in launch files."""

from __future__ import annotations

import re
from typing import Mapping

from rqt_mrta_py.model import ROBOT_TOKEN, TASK_TOKEN

__all__ = ["INDEX_TOKEN", "PACKAGE_TOKEN", "SIZE_TOKEN", "TOKENS", "has_token", "substitute"]

INDEX_TOKEN = "@index@"
SIZE_TOKEN = "@array_size@"
PACKAGE_TOKEN = "@package@"

TOKENS: Mapping[str, str] = {
    ROBOT_TOKEN: "The robot's id, in what is copied for each robot.",
    TASK_TOKEN: "Within an array, the id of the task that the element stands for.",
    INDEX_TOKEN: "Within an array, the index of the element, from 0.",
    SIZE_TOKEN: "Within an array and beside it, the number of its elements.",
    PACKAGE_TOKEN: "The name of the application's package.",
}
"""What each token stands for."""

_TOKEN = re.compile("|".join(TOKENS))


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
