"""From an architecture's template and what is given to one robot's parameters, complete and checked."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Set, Tuple

from rqt_mrta_py.config.parameters.array_sizes import ArraySizer, element_name
from rqt_mrta_py.config.parameters.context import ArraySize, ParameterContext, Path, Place
from rqt_mrta_py.config.parameters.layers import Given, GivenValues, Layer
from rqt_mrta_py.config.parameters.values import WANTED, Scalar, check_value, parse_text
from rqt_mrta_py.config.substitution import INDEX_TOKEN, substitute
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import (
    TASK_TOKEN,
    ArrayTemplate,
    ConfigTemplate,
    MapTemplate,
    ParameterTemplate,
    TemplateItem,
)
from rqt_mrta_py.wording import accepted

__all__ = ["MANDATORY", "ResolvedParameters", "locate_problems", "resolve_parameters"]

MANDATORY = "is mandatory and has no value"
"""With this begins the message of a problem that a value would end."""

_MOST_VALUES = 10_000


@dataclass(frozen=True)
class ResolvedParameters:
    """Parameters of one robot, and where each was set.

    Attributes:
        robot_id: whose they are.
        values: nested, in template order, in the types of the template.
        sources: file and line by path, joined by ``/``.
        templates: what the architecture says of each, by path.
    """

    robot_id: str
    values: Mapping[str, Any]
    sources: Mapping[str, Tuple[str, int]]
    templates: Mapping[str, ParameterTemplate] = field(default_factory=dict)


def resolve_parameters(
    template: ConfigTemplate, layers: Sequence[Layer], context: ParameterContext
) -> ResolvedParameters:
    """Fill in a template.

    Args:
        template: of the architecture.
        layers: what is given; later ones cover earlier ones.
        context: for whom.

    Returns:
        A value for every parameter of the template, arrays in the sizes that apply.

    Raises:
        ConfigError: with every unknown path, wrong type, and mandatory parameter without a value.
    """
    resolver = _Resolver(GivenValues(layers, context.tokens), context)
    values = resolver.items(template.items, Place((), (), fixed=context.tokens))
    resolver.check_unknown()
    if resolver.problems:
        raise ConfigError(resolver.problems)
    return ResolvedParameters(context.robot_id, values, resolver.sources, resolver.templates)


def locate_problems(
    resolved: ResolvedParameters, found: Iterable[Tuple[str, str]], otherwise: str = ""
) -> Tuple[Problem, ...]:
    """Say where the parameters that a plugin objects to were set.

    Args:
        resolved: the parameters that it was asked about.
        found: path and message of each problem.
        otherwise: the file to name for a path that stands nowhere.

    Returns:
        The problems, sorted.
    """
    problems = []
    for path, message in found:
        within = (name for name in resolved.sources if name == path or name.startswith(f"{path}/"))
        source, line = resolved.sources.get(next(within, ""), (otherwise, 0))
        problems.append(Problem(source, line, "/".join((resolved.robot_id, path)), message))
    return tuple(sorted(set(problems)))


class _Resolver:
    """Walks a template once."""

    def __init__(self, given: GivenValues, context: ParameterContext) -> None:
        self._given = given
        self._context = context
        self._sizer = ArraySizer(given, context, self._problem)
        self._groups: Set[Path] = set()
        self._with_arrays: Set[Path] = set()
        self._arrays: List[Tuple[Path, re.Pattern[str], int]] = []
        self.sources: Dict[str, Tuple[str, int]] = {}
        self.templates: Dict[str, ParameterTemplate] = {}
        self.problems: List[Problem] = []

    def items(self, items: Sequence[TemplateItem], place: Place) -> Dict[str, Any]:
        self._groups.add(place.path)
        array = self._sizer.of(items, place)
        if array is not None:
            place = place.beside(array)
            self._with_arrays.add(place.path)
        values: Dict[str, Any] = {}
        for item in items:
            if isinstance(item, ParameterTemplate):
                size = array.size if array is not None and item.name == "size" else None
                inner = place.inner(item.name)
                value = self._parameter(item, inner, size)
                if value is not None:
                    _set(values, inner.path[len(place.path) :], value)
            elif isinstance(item, MapTemplate):
                inner = place.inner(item.name)
                _set(values, inner.path[len(place.path) :], self.items(item.items, inner))
            elif array is not None:
                self._elements(item, array, place, values)
        return values

    def check_unknown(self) -> None:
        """Note everything that was given and that no template asked for."""
        for path, given in self._given.unused():
            # How many elements an array has may not be known.
            if not self._context.partial or not any(path[: len(group)] == group for group in self._with_arrays):
                self._problem(path, given, self._why_unknown(path))

    def _elements(self, item: ArrayTemplate, array: ArraySize, place: Place, values: Dict[str, Any]) -> None:
        name = element_name(item, array.by_task)
        if INDEX_TOKEN in name:
            known = re.escape(substitute(name, place.fixed))
            pattern = re.compile(known.replace(re.escape(INDEX_TOKEN), "([0-9]{1,9})") + r"\Z")
            self._arrays.append((place.path, pattern, array.size))
        for index in range(array.size):
            if len(self.sources) > _MOST_VALUES:
                where = Given(None, True, self._context.values_source, 0)
                self._problem(place.path, where, f"make more than {_MOST_VALUES} parameters; give smaller sizes")
                return
            inner = place.element(name, index, array)
            if TASK_TOKEN in name and array.by_task and inner.task is None:
                where = Given(None, True, self._context.template_source, item.line)
                if not self._context.partial:
                    self._problem((*place.path, name), where, self._no_task(name))
                continue
            _set(values, inner.path[len(place.path) :], self.items(item.items, inner))

    def _parameter(self, item: ParameterTemplate, place: Place, size: Optional[int]) -> Optional[Scalar]:
        given = self._given.look_up(place)
        if given is None:
            text = item.value if item.value is not None else item.default
            if text is None and size is None:
                if self._context.partial:
                    return None
                where = Given(None, True, self._context.values_source, self._context.values_line)
                self._problem(place.path, where, f"{MANDATORY}; give {WANTED[item.type]}")
                return None
            given = Given(text, True, self._context.template_source, item.line)
        name = "/".join(place.path)
        self.sources[name] = (given.source, given.line)
        self.templates[name] = item
        if size is not None:
            return size
        try:
            if given.is_text:
                if self._context.partial and self._lacks_task(given.value, place):
                    return None
                return parse_text(self._substitute(given.value, place), item.type)
            return check_value(given.value, item.type)
        except ValueError as error:
            self._problem(place.path, given, str(error))
            return None

    def _substitute(self, text: str, place: Place) -> str:
        if self._lacks_task(text, place):
            raise ValueError(self._no_task(text))
        return substitute(text, place.tokens)

    def _lacks_task(self, text: str, place: Place) -> bool:
        return TASK_TOKEN in text and place.in_task_array and place.task is None

    def _no_task(self, text: str) -> str:
        have = ", ".join(self._context.tasks) or "none"
        return f"stands for a task ({text}), but no task is left for it; the robot's tasks: {have}"

    def _why_unknown(self, path: Path) -> str:
        known = [tuple(name.split("/")) for name in self.sources]
        if path in self._groups or any(other[: len(path)] == path for other in known):
            return "is a group of parameters, not a value; give the parameters in it"
        for prefix, pattern, size in self._arrays:
            inside = path[: len(prefix)] == prefix and len(path) > len(prefix)
            match = pattern.match(path[len(prefix)]) if inside else None
            if match is not None and int(match.group(1)) >= size:
                return f"is of element {match.group(1)}, but size is {size}; elements count from 0"
        depth = 0
        while any(other[: depth + 1] == path[: depth + 1] for other in known):
            depth += 1
            if path[:depth] in known:
                return f"is not known; {'/'.join(path[:depth])} is a value, not a group"
        siblings = dict.fromkeys(other[depth] for other in known if other[:depth] == path[:depth])
        return f"is not known; {accepted(path[depth], siblings)}"

    def _problem(self, path: Path, given: Given, message: str) -> None:
        robot = (self._context.robot_id,) if self._context.robot_id else ()
        self.problems.append(Problem(given.source, given.line, "/".join((*robot, *path)), message))


def _set(values: Dict[str, Any], path: Sequence[str], value: Any) -> None:
    """Put a value at a nested path; groups that meet there are joined."""
    for name in path[:-1]:
        inner = values.setdefault(name, {})
        if not isinstance(inner, dict):
            inner = values[name] = {}
        values = inner
    present = values.get(path[-1])
    if isinstance(present, dict) and isinstance(value, dict):
        present.update(value)
    else:
        values[path[-1]] = value
