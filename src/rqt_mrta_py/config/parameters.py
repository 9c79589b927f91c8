"""From an architecture's template and what is given to one robot's parameters, complete and checked."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Set, Tuple

from rqt_mrta_py.config.layers import Given, Layer, Path
from rqt_mrta_py.config.values import WANTED, Scalar, check_value, parse_text
from rqt_mrta_py.config.wording import accepted, shown
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ArrayTemplate, ConfigTemplate, MapTemplate, ParameterTemplate, ParameterType, TemplateItem

__all__ = ["ParameterContext", "ResolvedParameters", "locate_problems", "resolve_parameters"]

_MOST_ELEMENTS = 1000
_TASK_TOKEN = "@task_id@"
_SIZE_TOKEN = "@array_size@"


@dataclass(frozen=True)
class ParameterContext:
    """For whom parameters are resolved.

    Attributes:
        robot_id: normalised; empty for a config that no robot owns.
        tasks: ids of the tasks that the robot may carry out, in order.
        all_tasks: True if each of them must have its element; False if the application names no tasks for the robot.
        package: of the application.
        template_source: file of the template.
        values_source: file in which a missing value would be given.
    """

    robot_id: str
    tasks: Tuple[str, ...]
    all_tasks: bool
    package: str
    template_source: str
    values_source: str


@dataclass(frozen=True)
class ResolvedParameters:
    """Parameters of one robot, and where each was set.

    Attributes:
        robot_id: whose they are.
        values: nested, in template order, in the types of the template.
        sources: file and line by path, joined by ``/``.
    """

    robot_id: str
    values: Mapping[str, Any]
    sources: Mapping[str, Tuple[str, int]]


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
    given: Layer = {}
    for layer in layers:
        given.update(layer)
    resolver = _Resolver(given, context)
    values = resolver.items(template.items, _Place((), ()))
    resolver.check_unknown()
    if resolver.problems:
        raise ConfigError(resolver.problems)
    return ResolvedParameters(context.robot_id, values, resolver.sources)


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


@dataclass(frozen=True)
class _Place:
    """Where in the parameters the resolver is: the real path, and the one with ``@index@``."""

    path: Path
    pattern: Path
    index: Optional[int] = None
    task: Optional[str] = None
    in_task_array: bool = False
    size: Optional[int] = None

    def inner(self, name: str, **changes: Any) -> _Place:
        index, task = changes.get("index", self.index), changes.get("task", self.task)
        in_task_array = changes.get("in_task_array", self.in_task_array)
        real = name if index is None else name.replace("@index@", str(index))
        return _Place(
            (*self.path, *real.split("/")), (*self.pattern, *name.split("/")), index, task, in_task_array, self.size
        )


@dataclass
class _Array:
    """The elements that an array has."""

    size: int
    tasks: Dict[int, str] = field(default_factory=dict)
    by_task: bool = False


class _Resolver:
    """Walks a template once."""

    def __init__(self, given: Layer, context: ParameterContext) -> None:
        self._given = given
        self._context = context
        self._used: Set[Path] = set()
        self._groups: Set[Path] = set()
        self._arrays: List[Tuple[Path, re.Pattern[str], int]] = []
        self.sources: Dict[str, Tuple[str, int]] = {}
        self.problems: List[Problem] = []

    def items(self, items: Sequence[TemplateItem], place: _Place) -> Dict[str, Any]:
        self._groups.add(place.path)
        array = self._array(items, place)
        values: Dict[str, Any] = {}
        for item in items:
            if isinstance(item, ParameterTemplate):
                size = array.size if array is not None and item.name == "size" else None
                value = self._parameter(item, place.inner(item.name), size)
                if value is not None:
                    _set(values, item.name.split("/"), value)
            elif isinstance(item, MapTemplate):
                inner = place.inner(item.name)
                _set(values, inner.path[len(place.path) :], self.items(item.items, inner))
            elif array is not None:
                self._elements(item, array, place, values)
        return values

    def check_unknown(self) -> None:
        """Note everything that was given and that no template asked for."""
        for path, given in self._given.items():
            if path in self._used:
                continue
            self._problem(path, given, self._why_unknown(path))

    def _elements(self, item: ArrayTemplate, array: _Array, place: _Place, values: Dict[str, Any]) -> None:
        name = item.name if "@index@" in item.name else f"{item.name}@index@"
        pattern = re.compile(re.escape(name).replace(re.escape("@index@"), "([0-9]{1,9})") + r"\Z")
        self._arrays.append((place.path, pattern, array.size))
        for index in range(array.size):
            inner = place.inner(name, index=index, task=array.tasks.get(index, place.task), in_task_array=array.by_task)
            _set(values, inner.path[len(place.path) :], self.items(item.items, inner))

    def _parameter(self, item: ParameterTemplate, place: _Place, size: Optional[int]) -> Optional[Scalar]:
        given = self._look_up(place)
        if given is None:
            text = item.value if item.value is not None else item.default
            if text is None and size is None:
                where = Given(None, True, self._context.values_source, 0)
                self._problem(place.path, where, f"is mandatory and has no value; give {WANTED[item.type]}")
                return None
            given = Given(text, True, self._context.template_source, item.line)
        self.sources["/".join(place.path)] = (given.source, given.line)
        if size is not None:
            return size
        try:
            if given.is_text:
                return parse_text(self._substitute(given.value, place), item.type)
            return check_value(given.value, item.type)
        except ValueError as error:
            self._problem(place.path, given, str(error))
            return None

    def _look_up(self, place: _Place) -> Optional[Given]:
        for path in (place.path, place.pattern):
            if path in self._given:
                self._used.update(key for key in (place.path, place.pattern) if key in self._given)
                return self._given[path]
        return None

    def _substitute(self, text: str, place: _Place) -> str:
        tokens = {"@robot_id@": self._context.robot_id, "@package@": self._context.package}
        if place.index is not None:
            tokens["@index@"] = str(place.index)
        if _TASK_TOKEN in text:
            if place.task is None:
                have = ", ".join(self._context.tasks) or "none"
                raise ValueError(f"stands for a task ({text}), but no task is left for it; the robot's tasks: {have}")
            tokens[_TASK_TOKEN] = place.task
        for token, value in tokens.items():
            text = text.replace(token, value)
        return text

    def _array(self, items: Sequence[TemplateItem], place: _Place) -> Optional[_Array]:
        """Find out how many elements the arrays of a group have, and for which task each element is."""
        arrays = [item for item in items if isinstance(item, ArrayTemplate)]
        sizes = [item for item in items if isinstance(item, ParameterTemplate) and item.name == "size"]
        if not arrays or not sizes:
            return None
        by_task = not place.in_task_array and any(_mentions_task(array.items) for array in arrays)
        seen = max([self._highest_index(array, place) + 1 for array in arrays])
        explicit = self._explicit_size(sizes[0], place)
        if not by_task:
            return _Array(explicit if explicit is not None else self._implied_size(sizes[0], place, seen))
        seen = seen if explicit is None else min(seen, explicit)
        claims = self._claims(arrays, place, seen)
        left = [task for task in self._context.tasks if task not in claims.values()]
        free = [index for index in range(seen + len(left)) if index not in claims]
        tasks = {**claims, **dict(zip(free, left))}
        size = explicit if explicit is not None else max([seen, *(index + 1 for index in tasks)])
        missing = [task for index, task in tasks.items() if index >= size]
        if missing and self._context.all_tasks:
            path = (*place.path, "size")
            given = self._given.get(path) or Given(None, True, self._context.template_source, sizes[0].line)
            self._problem(
                path, given, f"is {size}, which leaves no element for {', '.join(missing)}; give {len(tasks)}"
            )
        return _Array(size, {index: tasks[index] for index in sorted(tasks)}, by_task=True)

    def _explicit_size(self, item: ParameterTemplate, place: _Place) -> Optional[int]:
        """Give the size that a layer gives as a number; None if none does."""
        inner = place.inner(item.name)
        given = self._look_up(inner)
        if given is None or given.value == _SIZE_TOKEN:
            return None
        try:
            size = parse_text(given.value, ParameterType.INT) if given.is_text else check_value(given.value, item.type)
            if isinstance(size, int) and 0 <= size <= _MOST_ELEMENTS:
                return size
            raise ValueError(f"must be a whole number from 0 to {_MOST_ELEMENTS} (got {shown(size)})")
        except ValueError as error:
            self._problem(inner.path, given, str(error))
            return None

    def _implied_size(self, item: ParameterTemplate, place: _Place, seen: int) -> int:
        texts = [text for text in (item.value, item.default) if text is not None]
        numbers = [int(text) for text in texts if re.match(r"[0-9]{1,9}\Z", text)]
        if texts and texts[0] == _SIZE_TOKEN:
            return seen or (min(numbers[0], _MOST_ELEMENTS) if numbers else 0)
        if not texts:
            where = Given(None, True, self._context.values_source, 0)
            self._problem((*place.path, "size"), where, "is mandatory and has no value; give a whole number")
        return min(numbers[0], _MOST_ELEMENTS) if numbers else seen

    def _highest_index(self, array: ArrayTemplate, place: _Place) -> int:
        """Give the highest index for which a layer gives anything; -1 if there is none."""
        before, token, after = array.name.partition("@index@")
        pattern = re.compile(f"{re.escape(before)}([0-9]{{1,4}}){re.escape(after if token else '')}\\Z")
        depth = len(place.path)
        highest = -1
        for path in self._given:
            if len(path) > depth and path[:depth] == place.path:
                match = pattern.match(path[depth])
                if match is not None and int(match.group(1)) < _MOST_ELEMENTS:
                    highest = max(highest, int(match.group(1)))
        return highest

    def _claims(self, arrays: Sequence[ArrayTemplate], place: _Place, seen: int) -> Dict[int, str]:
        """Give the tasks that elements name themselves, by index."""
        claims: Dict[int, str] = {}
        for array in arrays:
            name = array.name if "@index@" in array.name else f"{array.name}@index@"
            for item in array.items:
                if not isinstance(item, ParameterTemplate) or _TASK_TOKEN not in (item.value, item.default):
                    continue
                for index in range(seen):
                    given = self._given.get(place.inner(name, index=index).inner(item.name).path)
                    if given is not None and isinstance(given.value, str) and _TASK_TOKEN not in given.value:
                        claims.setdefault(index, given.value)
        return claims

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


def _mentions_task(items: Sequence[TemplateItem]) -> bool:
    return any(
        _TASK_TOKEN in (item.value or "") or _TASK_TOKEN in (item.default or "")
        if isinstance(item, ParameterTemplate)
        else isinstance(item, MapTemplate) and _mentions_task(item.items)
        for item in items
    )


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
