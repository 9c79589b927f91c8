"""Where values of parameters come from: XML configs, YAML files, the command line; later layers cover earlier ones."""

from __future__ import annotations

from typing import Any, Dict, Iterable, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Set, Tuple, Union

from rqt_mrta_py.config.parameters.context import Path, Place
from rqt_mrta_py.config.substitution import substitute
from rqt_mrta_py.config.yaml.text import YamlNode, parse_yaml
from rqt_mrta_py.errors import ConfigError, Problem
from rqt_mrta_py.model import ArrayTemplate, MapTemplate, ParameterTemplate, TemplateItem, normalise_id
from rqt_mrta_py.wording import accepted, shown

__all__ = [
    "COMMAND_LINE",
    "Given",
    "GivenValues",
    "Layer",
    "split_overrides",
    "value_layer",
    "xml_layer",
    "yaml_layer",
]

COMMAND_LINE = "--set"
"""What problems name in the place of a file for values from the command line."""


class Given(NamedTuple):
    """A value that somebody gave.

    Attributes:
        value: text, or what YAML gives.
        is_text: True if the value is text to be substituted and parsed.
        source: file, or ``COMMAND_LINE``.
        line: there; 0 where a line makes no sense.
    """

    value: Any
    is_text: bool
    source: str
    line: int


Layer = Dict[Path, Given]
"""Values by path; a path may hold ``@index@`` for all elements of an array."""


class GivenValues:
    """All layers on top of each other, and what of them was asked for.

    Args:
        layers: later ones cover earlier ones.
        tokens: what tokens in paths stand for.
    """

    def __init__(self, layers: Sequence[Layer], tokens: Mapping[str, str]) -> None:
        self._values: Layer = {}
        self._ranks: Dict[Path, int] = {}
        for rank, layer in enumerate(layers):
            for path, given in layer.items():
                name = "/".join(path)
                real = tuple(substitute(name, tokens).split("/")) if "@" in name else path
                self._values[real] = given
                self._ranks[real] = rank
        self._used: Set[Path] = set()

    @property
    def paths(self) -> Tuple[Path, ...]:
        """Every path for which there is a value."""
        return tuple(self._values)

    def get(self, path: Path) -> Optional[Given]:
        """Give the value of exactly this path, without counting it as used."""
        return self._values.get(path)

    def look_up(self, place: Place) -> Optional[Given]:
        """Give the value for a place, of one layer its own before one for all elements; both count as used."""
        found = [path for path in (place.path, place.pattern) if path in self._values]
        self._used.update(found)
        return self._values[max(found, key=self._ranks.__getitem__)] if found else None

    def unused(self) -> Iterator[Tuple[Path, Given]]:
        """Give what was never looked up, in the order of the layers."""
        return ((path, given) for path, given in self._values.items() if path not in self._used)


def xml_layer(items: Iterable[TemplateItem], source: str) -> Layer:
    """Collect what a config of an rqt_mrta.xml gives.

    Args:
        items: of the config.
        source: the file.
    """
    return dict(_walk_items(items, (), source))


def yaml_layer(text: Union[str, bytes], source: str) -> Layer:
    """Collect what a parameter file gives.

    Args:
        text: the whole file: a mapping, nested as the parameters are.
        source: the file.

    Raises:
        ConfigError: it is not YAML that is accepted here, or no mapping.
    """
    node = parse_yaml(text, source)
    if node is None:
        return {}
    if not isinstance(node.value, dict):
        raise ConfigError([Problem(source, node.line, "", f"must be a mapping (got {shown(node.plain())})")])
    return dict(_walk_node(node, (), source))


def value_layer(values: Mapping[str, Any], source: str) -> Layer:
    """Collect what nested values give, as a parameter server holds them.

    Args:
        values: nested as the parameters are.
        source: by which problems name them.
    """
    return dict(_walk_values(values, (), source))


def split_overrides(overrides: Sequence[str], robots: Sequence[str]) -> Tuple[Dict[str, Layer], Tuple[Problem, ...]]:
    """Sort the values of the command line by robot.

    Args:
        overrides: each ``<robot>/<path>=<value>``.
        robots: ids of the team.

    Returns:
        A layer for each robot that is named, where of one path the last value counts; and a problem for each
        override that has another form, or names a robot that does not exist.
    """
    layers: Dict[str, Layer] = {}
    problems: List[Problem] = []
    for override in overrides:
        name, equals, value = override.partition("=")
        path = tuple(part.strip() for part in normalise_id(name.strip()).split("/"))
        if not equals or len(path) < 2 or not all(path):
            message = "must have the form <robot>/<parameter>=<value>, such as robot1/spin_rate=2.0"
            problems.append(Problem(COMMAND_LINE, 0, override, message))
        elif path[0] not in robots:
            problems.append(Problem(COMMAND_LINE, 0, name, f"{path[0]!r} is no robot; {accepted(path[0], robots)}"))
        else:
            layers.setdefault(path[0], {})[path[1:]] = Given(value.strip(), True, COMMAND_LINE, 0)
    return layers, tuple(problems)


def _walk_values(values: Mapping[str, Any], path: Path, source: str) -> Iterator[Tuple[Path, Given]]:
    for name, value in values.items():
        if isinstance(value, Mapping):
            yield from _walk_values(value, (*path, name), source)
        else:
            yield (*path, name), Given(value, False, source, 0)


def _walk_items(items: Iterable[TemplateItem], path: Path, source: str) -> Iterator[Tuple[Path, Given]]:
    for item in items:
        here = (*path, *item.name.split("/"))
        if isinstance(item, (MapTemplate, ArrayTemplate)):
            yield from _walk_items(item.items, here, source)
        else:
            text = _text_of(item)
            if text is not None:
                yield here, Given(text, True, source, item.line)


def _text_of(item: ParameterTemplate) -> Optional[str]:
    return item.value if item.value is not None else item.default


def _walk_node(node: YamlNode, path: Path, source: str) -> Iterator[Tuple[Path, Given]]:
    if isinstance(node.value, dict):
        for name, child in node.value.items():
            yield from _walk_node(child, (*path, *(part for part in name.split("/") if part)), source)
    elif node.value is not None:
        yield path, Given(node.plain(), False, source, node.line)
