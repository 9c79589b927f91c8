"""The two flavours of rqt_mrta.xml, told apart by their content and, where it stands, by ``format=``."""

from __future__ import annotations

from typing import Callable, TypeVar, Union

from rqt_mrta_py.config.problems import Problems
from rqt_mrta_py.config.xml.element import Element, open_document
from rqt_mrta_py.wording import shown

__all__ = ["ROOT", "read_flavour"]

_Spec = TypeVar("_Spec")

ROOT = "rqt_mrta"
"""The name of the root element."""


def read_flavour(
    text: Union[str, bytes], path: str, wanted: str, other: str, read: Callable[[Element], _Spec]
) -> _Spec:
    """Read a file of one flavour, whole.

    Args:
        text: the whole file.
        path: by which problems name the file.
        wanted: ``architecture`` or ``application``.
        other: the other one.
        read: makes the specification of the root element; what it leaves unread is a problem.

    Raises:
        ConfigError: with everything that is wrong, sorted by line.
    """
    problems = Problems(path)
    root = open_document(text, path, ROOT, problems)
    _check_flavour(root, wanted, other)
    spec = read(root)
    root.finish()
    problems.raise_if_any()
    return spec


def _check_flavour(root: Element, wanted: str, other: str) -> None:
    """Note a contradiction between a file and the flavour it is read as; ``format=`` may be absent.

    Args:
        root: the document's root element.
        wanted: ``architecture`` or ``application``.
        other: the other one.
    """
    declared = root.attribute("format")
    if declared not in (None, wanted):
        root.problem("@format", f"says {shown(declared)}, but the file is read as {wanted!r}; say {wanted!r}")
    for element in root.repeated(other):
        if not element.empty:
            element.problem("", f"belongs to an {other}, but the file is read as an {wanted}")
        element.skip()
