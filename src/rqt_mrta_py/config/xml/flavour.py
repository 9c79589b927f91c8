"""The two flavours of rqt_mrta.xml, told apart by their content and, where it stands, by ``format=``."""

from __future__ import annotations

from typing import Callable, Optional, Tuple, TypeVar, Union

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.xml.element import Element, open_document
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.wording import shown

__all__ = ["ROOT", "read_flavour"]

_Spec = TypeVar("_Spec")

ROOT = "rqt_mrta"
"""The name of the root element."""


def read_flavour(
    text: Union[str, bytes], path: str, wanted: str, other: str, read: Callable[[Element], Optional[_Spec]]
) -> Tuple[_Spec, Tuple[Problem, ...]]:
    """Read a file of one flavour, as far as it can be read.

    Args:
        text: the whole file.
        path: by which problems name the file.
        wanted: ``architecture`` or ``application``.
        other: the other one.
        read: makes the specification of the root element, which it finishes; None if that cannot be done.

    Returns:
        The specification, without what is wrong, and everything that is wrong, sorted by line.

    Raises:
        ConfigError: no specification can be made; with everything that is wrong.
    """
    problems = Problems(path)
    root = open_document(text, path, ROOT, problems)
    is_wanted = _check_flavour(root, wanted, other)
    spec = read(root)
    if spec is None or not is_wanted:
        raise ConfigError(problems.found)
    return spec, problems.found


def _check_flavour(root: Element, wanted: str, other: str) -> bool:
    """Note a contradiction between a file and the flavour it is read as; ``format=`` may be absent.

    Args:
        root: the document's root element.
        wanted: ``architecture`` or ``application``.
        other: the other one.

    Returns:
        False if something of the other flavour is there, whatever ``format=`` says.
    """
    is_wanted = True
    declared = root.attribute("format")
    if declared not in (None, wanted):
        root.problem("@format", f"says {shown(declared)}, but the file is read as {wanted!r}; say {wanted!r}")
    for element in root.repeated(other):
        if not element.empty:
            element.problem("", f"belongs to an {other}, but the file is read as an {wanted}")
            is_wanted = False
        element.skip()
    return is_wanted
