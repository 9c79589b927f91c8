"""The elements that both flavours of rqt_mrta.xml know: templates of parameters and of launch files."""

from __future__ import annotations

from typing import Mapping, Tuple

from rqt_mrta_py.config.schema.forms import Content, ElementForm
from rqt_mrta_py.model import ParameterType

__all__ = ["CONFIGS", "GROUPS", "LAUNCHES"]

_ITEM_NAME = ElementForm(
    "name",
    "Name of the parameter, group or array; a slash makes it a nested path.",
    Content.TEXT,
    "run, configure",
    required=True,
)

_PARAM = ElementForm(
    "param",
    "One parameter; `param`, `params` and `array` share one count within their parent.",
    numbered=True,
    plain=False,
    children=(
        _ITEM_NAME,
        ElementForm(
            "type",
            "Type of the value; the numbers are those of Qt's types, any other word means a text.",
            Content.TEXT,
            "run, configure",
            default="string",
            spellings=(*(kind.value for kind in ParameterType), "1", "2", "6", "10"),
        ),
        ElementForm("value", "The value itself, where it is settled.", Content.TEXT, "run, configure"),
        ElementForm(
            "default",
            "The value where nobody gives another; without value and default somebody has to.",
            Content.TEXT,
            "run, configure",
        ),
        ElementForm(
            "tool_tip",
            "One sentence for the user; it names the unit in square brackets.",
            Content.TEXT,
            "show, new, configure",
        ),
    ),
)

_PARAMS = ElementForm(
    "params",
    "A group of parameters.",
    numbered=True,
    plain=False,
    children=(_ITEM_NAME,),
    group="items",
)

_ARRAY = ElementForm(
    "array",
    "A group that stands once for each element, in a params that also has a param named `size`; its name holds "
    "`@index@`, which else is appended, or `@task_id@` where elements stand for tasks.",
    numbered=True,
    plain=False,
    children=(_ITEM_NAME,),
    group="items",
)

GROUPS: Mapping[str, Tuple[ElementForm, ...]] = {"items": (_PARAM, _PARAMS, _ARRAY)}
"""Elements that may hold one another."""

CONFIGS = ElementForm(
    "configs",
    "Parameters: templates of them in an architecture, filled in in an application.",
    children=(
        ElementForm(
            "config",
            "One file of parameters, `config/<id>.yaml`.",
            numbered=True,
            plain=False,
            children=(
                ElementForm(
                    "id",
                    "Its name; an application's config of this name is for all robots, `<robot>_<id>` for one.",
                    Content.ID,
                    "run, configure",
                    required=True,
                ),
            ),
            group="items",
        ),
    ),
)

_ARGUMENT = ElementForm(
    "arg",
    "An argument of the included file; a user gives it where it has no default.",
    numbered=True,
    plain=False,
    children=(
        ElementForm("name", "Its name.", Content.TEXT, "configure", required=True),
        ElementForm("value", "Its value.", Content.TEXT, "configure"),
        ElementForm("default", "Its value where none is given.", Content.TEXT, "configure"),
    ),
)

LAUNCHES = ElementForm(
    "launches",
    "Templates of launch files.",
    children=(
        ElementForm(
            "launch",
            "One launch file, `launch/<id>.launch`.",
            numbered=True,
            plain=False,
            children=(
                ElementForm("id", "Its name.", Content.ID, "configure", required=True),
                ElementForm(
                    "includes",
                    "The launch files that it includes.",
                    children=(
                        ElementForm(
                            "include",
                            "One of them.",
                            numbered=True,
                            plain=False,
                            children=(
                                ElementForm(
                                    "file",
                                    "The file, such as `$(find alliance)/launch/alliance.launch`.",
                                    Content.TEXT,
                                    "configure",
                                    required=True,
                                ),
                                ElementForm("args", "Its arguments.", children=(_ARGUMENT,)),
                            ),
                        ),
                    ),
                ),
            ),
        ),
    ),
)
