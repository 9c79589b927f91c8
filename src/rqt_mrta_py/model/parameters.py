"""Templates of parameters, as an architecture declares and an application fills them in (rqt_mrta grammar, configs)."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum
from typing import Optional, Tuple, Union

__all__ = ["ArrayTemplate", "ConfigTemplate", "MapTemplate", "ParameterTemplate", "ParameterType", "TemplateItem"]


class ParameterType(Enum):
    """The type of a single parameter's value; the value is the word that files use."""

    BOOL = "bool"
    INT = "int"
    DOUBLE = "double"
    STRING = "string"


@dataclass(frozen=True)
class ParameterTemplate:
    """A single parameter (``param_<k>``).

    Attributes:
        name: as in the file; a slash makes it a nested path.
        type: the type of its value.
        value: the value as text, substitutions not yet made; None if not given.
        default: the default as text, substitutions not yet made; None makes the parameter mandatory.
        tool_tip: one sentence for the user; by custom it names the unit in square brackets.
        line: 1-based line in its file, 0 if unknown.
    """

    name: str
    type: ParameterType
    value: Optional[str] = None
    default: Optional[str] = None
    tool_tip: str = ""
    line: int = field(default=0, compare=False)


@dataclass(frozen=True)
class MapTemplate:
    """A named group of parameters (``params_<k>``)."""

    name: str
    items: Tuple[TemplateItem, ...]
    line: int = field(default=0, compare=False)


@dataclass(frozen=True)
class ArrayTemplate:
    """A group that is repeated ``size`` times (``array_<k>``); its name normally holds ``@index@``."""

    name: str
    items: Tuple[TemplateItem, ...]
    line: int = field(default=0, compare=False)


TemplateItem = Union[ParameterTemplate, MapTemplate, ArrayTemplate]


@dataclass(frozen=True)
class ConfigTemplate:
    """One parameter file (``config_<i>``), written to ``config/<id>.yaml``."""

    id: str
    items: Tuple[TemplateItem, ...]
    line: int = field(default=0, compare=False)
