"""Parameters by their paths: in templates, and among nested values."""

from __future__ import annotations

from typing import Any, Iterator, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.config.parameters.array_sizes import element_name
from rqt_mrta_py.config.parameters.context import Path
from rqt_mrta_py.config.substitution import INDEX_TOKEN
from rqt_mrta_py.model import ArrayTemplate, ParameterTemplate, TemplateItem

__all__ = ["leaves", "template_at"]


def template_at(items: Sequence[TemplateItem], path: Path) -> Optional[ParameterTemplate]:
    """Find what a template says of a parameter.

    Args:
        items: of the template.
        path: of the parameter; elements of arrays by their index, or ``@index@`` for any.

    Returns:
        The parameter's template; None where nothing is known of this path.
    """
    for item in items:
        name = element_name(item, by_task=False) if isinstance(item, ArrayTemplate) else item.name
        parts = tuple(name.split("/"))
        if len(parts) > len(path) or not all(_fits(one, other) for one, other in zip(parts, path)):
            continue
        rest = path[len(parts) :]
        if isinstance(item, ParameterTemplate):
            if not rest:
                return item
            continue
        found = template_at(item.items, rest)
        if found is not None:
            return found
    return None


def leaves(values: Mapping[str, Any]) -> Iterator[Tuple[Path, Any]]:
    """Give every single value of nested ones, with its path, in their order."""
    for name, value in values.items():
        if isinstance(value, Mapping):
            for path, inner in leaves(value):
                yield (name, *path), inner
        else:
            yield (name,), value


def _fits(pattern: str, name: str) -> bool:
    before, token, after = pattern.partition(INDEX_TOKEN)
    if not token:
        return pattern == name
    index = name[len(before) : len(name) - len(after)]
    return name.startswith(before) and name.endswith(after) and (index.isdigit() or index == token)
