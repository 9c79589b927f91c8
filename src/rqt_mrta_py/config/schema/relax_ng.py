"""RELAX NG grammars, written from the forms of XML files.

RELAX NG has no numbered names: a grammar lists them up to a number. It accepts what the readers accept, but for higher
numbers, and refuses every element and attribute that they do not know; ids and references it cannot check.
"""

from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence

from lxml import etree

from rqt_mrta_py.config.schema.forms import Content, ElementForm, XmlForm
from rqt_mrta_py.config.xml.tree import document_text

__all__ = ["HIGHEST_NUMBER", "relax_ng"]

HIGHEST_NUMBER = 99
"""Up to here numbered elements are listed."""

_NAMESPACE = "http://relaxng.org/ns/structure/1.0"
_NOTES = "http://relaxng.org/ns/compatibility/annotations/1.0"
_TYPES = "http://www.w3.org/2001/XMLSchema-datatypes"
_SEGMENT = "[A-Za-z][A-Za-z0-9_]*"
_PATTERNS = {
    Content.TEXT: r"[\s\S]*\S[\s\S]*",
    Content.ID: r"\S+",
    Content.TOPIC: "/([A-Za-z0-9_/]|@robot_id@|@task_id@)*",
    Content.MESSAGE_TYPE: f"{_SEGMENT}/{_SEGMENT}",
    Content.FIELD: f"{_SEGMENT}(/{_SEGMENT})*",
    Content.WHOLE: "[0-9]{1,9}",
    Content.SECONDS: r"\+?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?",
}


def relax_ng(form: XmlForm) -> str:
    """Write the grammar of a form.

    Args:
        form: of the file.

    Returns:
        RELAX NG in its XML syntax.
    """
    prefixes: Any = {None: _NAMESPACE, "a": _NOTES}
    grammar = etree.Element(f"{{{_NAMESPACE}}}grammar", {"datatypeLibrary": _TYPES}, prefixes)
    start = _add(grammar, "start")
    root = _element(start, form.root)
    attribute = _add(_add(root, "optional"), "attribute", {"name": "format"})
    _data(attribute, form.format)
    _children(root, form.root)
    for name, elements in form.groups.items():
        _choices(_add(grammar, "define", {"name": name}), elements)
    return document_text(grammar)


def _element(parent: etree._Element, element: ElementForm) -> etree._Element:
    """Append an element with its names and its documentation."""
    if not element.numbered:
        node = _add(parent, "element", {"name": element.name})
        etree.SubElement(node, f"{{{_NOTES}}}documentation").text = element.summary
        return node
    node = _add(parent, "element")
    etree.SubElement(node, f"{{{_NOTES}}}documentation").text = element.summary
    names = _add(node, "choice")
    plain = [element.name] if element.plain else []
    for name in (*plain, *(f"{element.name}_{number}" for number in range(HIGHEST_NUMBER + 1))):
        _add(names, "name").text = name
    return node


def _whole(parent: etree._Element, element: ElementForm, optional: bool) -> None:
    """Append an element with what it holds; an empty one equals an absent one."""
    node = _element(parent, element)
    if element.content is Content.NOTHING:
        _add(node, "empty")
    elif element.content is not Content.ELEMENTS:
        _leaf(_add(node, "choice") if optional else node, element, optional)
    elif optional:
        choice = _add(node, "choice")
        _add(choice, "empty")
        _children(_add(choice, "group"), element)
    else:
        _children(node, element)


def _leaf(parent: etree._Element, element: ElementForm, optional: bool) -> None:
    if optional:
        _add(parent, "empty")
    if element.content is Content.SECONDS:
        data = _add(parent, "data", {"type": "double"})
        _add(data, "param", {"name": "pattern"}).text = _PATTERNS[element.content]
        _add(data, "param", {"name": "minExclusive"}).text = "0"
    else:
        _data(parent, _PATTERNS[element.content], pattern=True)


def _children(parent: etree._Element, element: ElementForm) -> None:
    """Append everything that an element may hold, in any order."""
    within = _add(parent, "interleave")
    for child in element.children:
        if child.numbered:
            _whole(_add(within, "zeroOrMore"), child, optional=True)
        elif child.required and not element.blank:
            _whole(within, child, optional=False)
        else:
            _whole(_add(within, "optional"), child, optional=True)
    if element.group:
        _add(_add(within, "zeroOrMore"), "ref", {"name": element.group})


def _choices(parent: etree._Element, elements: Sequence[ElementForm]) -> None:
    choice = _add(parent, "choice")
    for element in elements:
        _whole(choice, element, optional=True)


def _data(parent: etree._Element, text: str, pattern: bool = False) -> None:
    """Append a text between white space that does not count: one text, or all that fit a pattern."""
    if not pattern:
        _add(parent, "value", {"type": "token"}).text = text
        return
    data = _add(parent, "data", {"type": "token"})
    _add(data, "param", {"name": "pattern"}).text = text


def _add(parent: etree._Element, tag: str, attributes: Optional[Mapping[str, str]] = None) -> etree._Element:
    return etree.SubElement(parent, f"{{{_NAMESPACE}}}{tag}", dict(attributes or {}))
