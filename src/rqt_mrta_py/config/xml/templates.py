"""The ``configs`` element of the rqt_mrta grammar: templates of parameters, empty or filled in."""

from __future__ import annotations

from typing import Dict, List, Optional, Sequence, Tuple

from rqt_mrta_py.config.parameters.values import parse_text
from rqt_mrta_py.config.substitution import has_token
from rqt_mrta_py.config.xml.element import Element, Text
from rqt_mrta_py.config.xml.ids import read_id
from rqt_mrta_py.model import (
    ArrayTemplate,
    ConfigTemplate,
    MapTemplate,
    ParameterTemplate,
    ParameterType,
    TemplateItem,
)

__all__ = ["read_configs"]

_TYPES = {
    **{kind.value: kind for kind in ParameterType},
    # The original saves the numbers of Qt's types.
    "1": ParameterType.BOOL,
    "2": ParameterType.INT,
    "6": ParameterType.DOUBLE,
    "10": ParameterType.STRING,
}


def read_configs(root: Element, places: Dict[str, str]) -> Tuple[ConfigTemplate, ...]:
    """Read all configs of a file.

    Args:
        root: the document's root element.
        places: is given the id of each config that is returned, by its element.

    Returns:
        The configs in the order of their numbers.
    """
    holder = root.child("configs")
    if holder is None:
        return ()
    configs: Dict[str, ConfigTemplate] = {}
    for _, _, element in holder.numbered(["config"]):
        name = read_id(element)
        items = _read_items(element, in_map=False)
        element.finish()
        if name in configs:
            element.problem("id", f"{name!r} names two configs; the first one is in line {configs[name].line}")
        elif name:
            configs[name] = ConfigTemplate(name, items, element.line)
            places[element.path] = name
    holder.finish()
    return tuple(configs.values())


def _read_items(parent: Element, in_map: bool) -> Tuple[TemplateItem, ...]:
    items: List[TemplateItem] = []
    lines: Dict[str, int] = {}
    for kind, _, element in parent.numbered(["param", "params", "array"]):
        name = "/".join(part for part in element.required("name").split("/") if part)
        item: TemplateItem
        if kind == "param":
            item = _read_parameter(element, name)
        elif kind == "params":
            item = MapTemplate(name, _read_items(element, in_map=True), element.line)
        else:
            item = ArrayTemplate(name, _read_items(element, in_map=True), element.line)
            if not in_map:
                element.problem("", "is an array outside a params; put it into a params_<number>")
        element.finish()
        if not name:
            continue
        if name in lines:
            element.problem("name", f"{name!r} stands twice here; the first one is in line {lines[name]}")
            continue
        lines[name] = element.line
        items.append(item)
    if in_map:
        _check_size(parent, items)
    return tuple(items)


def _read_parameter(element: Element, name: str) -> ParameterTemplate:
    kind = _TYPES.get(element.string("type"), ParameterType.STRING)
    return ParameterTemplate(
        name=name,
        type=kind,
        value=_read_value(element, element.text("value"), "value", kind),
        default=_read_value(element, element.text("default"), "default", kind),
        tool_tip=element.string("tool_tip"),
        line=element.line,
    )


def _read_value(element: Element, found: Optional[Text], name: str, kind: ParameterType) -> Optional[str]:
    if found is None:
        return None
    if not has_token(found.value):
        try:
            parse_text(found.value, kind)
        except ValueError as error:
            element.problem(name, str(error), found.line)
            return None
    return found.value


def _check_size(parent: Element, items: Sequence[TemplateItem]) -> None:
    arrays = [item for item in items if isinstance(item, ArrayTemplate)]
    sized = any(isinstance(item, ParameterTemplate) and item.name == "size" for item in items)
    if arrays and not sized:
        parent.problem("", f"holds the array {arrays[0].name!r}, but no param named 'size'; add one of type int")
