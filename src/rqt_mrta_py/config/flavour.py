"""The two flavours of rqt_mrta.xml, told apart by their content and, where it stands, by ``format=``."""

from __future__ import annotations

from rqt_mrta_py.config.element import Element
from rqt_mrta_py.config.wording import shown

__all__ = ["ROOT", "check_flavour"]

ROOT = "rqt_mrta"
"""Name of the root element of both flavours."""


def check_flavour(root: Element, wanted: str, other: str) -> None:
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
