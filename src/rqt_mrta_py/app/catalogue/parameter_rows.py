"""Parameters in rows: what an architecture asks for, and what an application's robots get."""

from __future__ import annotations

import re
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple

from rqt_mrta_py.config.parameters.resolving import ResolvedParameters
from rqt_mrta_py.config.parameters.team import Team, config_name, resolve_shared, resolve_team
from rqt_mrta_py.model import ArrayTemplate, ConfigTemplate, MapTemplate, ParameterTemplate, TemplateItem

__all__ = ["resolved_rows", "template_rows", "unit_of", "written_rows"]

_UNIT = re.compile(r"\[([^\[\]]{1,20})\]")


def template_rows(configs: Sequence[ConfigTemplate]) -> List[Dict[str, Any]]:
    """Describe every parameter of some templates.

    Args:
        configs: of an architecture.

    Returns:
        A row for each, in file order; values and defaults are texts in which tokens still stand.
    """
    return [
        {
            "config": config.id,
            "path": path,
            "type": item.type.value,
            "value": item.value,
            "default": item.default,
            "tool_tip": item.tool_tip,
            "unit": unit_of(item.tool_tip),
            "mandatory": _is_mandatory(item),
        }
        for config in configs
        for path, item in _leaves(config.items, "")
    ]


def resolved_rows(team: Team) -> List[Dict[str, Any]]:
    """Describe every parameter of every robot, and those of configs that no robot owns.

    Args:
        team: whose.

    Returns:
        A row for each, by robot and then in the template's order: its value, of its type; the template's default, a
        text; the file and line that give the value, None if it is the template's.

    Raises:
        ConfigError: with everything that is wrong for any robot.
    """
    rows: List[Dict[str, Any]] = []
    for robot, resolved in resolve_team(team).items():
        rows.extend(_resolved(team, resolved, config_name(robot, team.template.id), robot))
    for config, resolved in resolve_shared(team).items():
        rows.extend(_resolved(team, resolved, config, None))
    return rows


def written_rows(configs: Sequence[ConfigTemplate], file: str) -> List[Dict[str, Any]]:
    """Describe what an application's file gives, where no template says more of it.

    Args:
        configs: of the application.
        file: in which they stand.
    """
    return [
        {
            "config": config.id,
            "path": path,
            "type": item.type.value,
            "value": item.value,
            "default": item.default,
            "tool_tip": item.tool_tip,
            "unit": unit_of(item.tool_tip),
            "mandatory": False,
            "robot": None,
            "source": {"file": file, "line": item.line},
        }
        for config in configs
        for path, item in _leaves(config.items, "")
    ]


def unit_of(tool_tip: str) -> Optional[str]:
    """Give the unit that a tool tip names in square brackets; None if it names none."""
    match = _UNIT.search(tool_tip)
    return match.group(1).strip() or None if match is not None else None


def _resolved(team: Team, resolved: ResolvedParameters, config: str, robot: Optional[str]) -> Iterator[Dict[str, Any]]:
    for path, item in resolved.templates.items():
        file, line = resolved.sources[path]
        yield {
            "config": config,
            "path": path,
            "type": item.type.value,
            "value": _value(resolved.values, path),
            "default": item.value if item.value is not None else item.default,
            "tool_tip": item.tool_tip,
            "unit": unit_of(item.tool_tip),
            "mandatory": _is_mandatory(item),
            "robot": robot,
            "source": None if file == str(team.architecture_file) else {"file": file, "line": line},
        }


def _value(values: Any, path: str) -> Any:
    for name in path.split("/"):
        values = values.get(name) if isinstance(values, dict) else None
    return values


def _is_mandatory(item: ParameterTemplate) -> bool:
    return item.value is None and item.default is None


def _leaves(items: Sequence[TemplateItem], above: str) -> Iterator[Tuple[str, ParameterTemplate]]:
    for item in items:
        path = f"{above}/{item.name}" if above else item.name
        if isinstance(item, (MapTemplate, ArrayTemplate)):
            yield from _leaves(item.items, path)
        else:
            yield path, item
