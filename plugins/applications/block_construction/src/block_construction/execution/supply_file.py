"""Files that say where blocks wait, and in which arena: YAML or JSON."""

from __future__ import annotations

import math
import re
import reprlib
from pathlib import Path
from typing import Any, Callable, Dict, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Set, Tuple

import yaml

from block_construction.diagram.block_set import LONGEST
from block_construction.documents import bounded_text
from block_construction.errors import ConstructionError
from block_construction.execution.arena import Arena
from block_construction.execution.supply import SupplyPlace, corner_places

__all__ = ["Supply", "read_supply", "supply_document", "supply_named", "supply_of"]

_MOST_BYTES = 1_000_000
_MOST_PLACES = 100
_MOST_TURNS = 10
_StartOf = Callable[[float], Tuple[float, float]]
_ARENA_KEYS = ("side", "cell", "robot_radius", "stand_off", "start")
_PLACE_KEYS = ("x", "y", "yaw", "blocks")

_CORNERS: Mapping[str, Tuple[Tuple[int, ...], ...]] = {
    "corners": ((2,), (1,), (3,), (3,)),
    "corners_all": ((1, 2, 3),) * 4,
}
"""Supplies that come with the package: what waits in the corners, from the lower left by rows."""


class _Loader(yaml.SafeLoader):
    """Reads mappings as they stand there: merging (``<<``) can double what there is with each line of a file."""

    def flatten_mapping(self, node: yaml.MappingNode) -> None:
        """Check the keys of a mapping, in place of merging others into it; one that comes twice would hide another."""
        seen: Set[str] = set()
        for key, _ in node.value:
            if key.tag == "tag:yaml.org,2002:merge":
                raise yaml.constructor.ConstructorError(None, None, "<< is not accepted", key.start_mark)
            if isinstance(key, yaml.ScalarNode) and key.value in seen:
                raise yaml.constructor.ConstructorError(None, None, f"{key.value!r} comes twice", key.start_mark)
            seen.add(str(key.value))


class Supply(NamedTuple):
    """An arena, and where blocks wait in it."""

    arena: Arena
    places: Tuple[SupplyPlace, ...]


def supply_named(given: str, *, others: Sequence[str] = (), start: Optional[_StartOf] = None) -> Supply:
    """Read a supply.

    Args:
        given: ``corners`` or ``corners_all``, which come with the package, or a path to a file.
        others: further names that the caller knows, for errors.
        start: gives where the robot begins in an arena of such a side [m], where it does not say so; None: as
            ``Arena`` has it.

    Raises:
        ConstructionError: it cannot be read; says where and what is accepted.
    """
    if given in _CORNERS:
        arena = Arena() if start is None else Arena(start=start(Arena.side))
        return Supply(arena, corner_places(arena, _CORNERS[given]))
    path = Path(given)
    try:
        text = bounded_text(path, _MOST_BYTES)
    except ConstructionError as error:
        raise ConstructionError(
            f"{error}; accepted are a YAML or JSON file, or {', '.join((*_CORNERS, *others))}"
        ) from error
    return read_supply(path.name, text, start)


def read_supply(name: str, text: str, start: Optional[_StartOf] = None) -> Supply:
    """Read a supply from YAML, of which JSON is a part.

    Args:
        name: of the file, for errors.
        text: its content.
        start: see ``supply_named``.

    Raises:
        ConstructionError: it is no such file; says where and what is accepted.
    """
    try:
        document = yaml.load(text, Loader=_Loader)
    except (LookupError, AttributeError) as error:
        # So the library ends on a !!bool, !!int or !!timestamp that is none.
        raise ConstructionError(f"{name}: neither YAML nor JSON (a value is not what its tag says)") from error
    except (yaml.YAMLError, RecursionError, ValueError) as error:
        raise ConstructionError(f"{name}: neither YAML nor JSON ({' '.join(str(error).split())})") from error
    return supply_of(name, document, start)


def supply_of(name: str, document: object, start: Optional[_StartOf] = None) -> Supply:
    """Make a supply of what a file holds.

    Args:
        name: of the file, for errors.
        document: ``arena``, which may be left out, and ``places``.
        start: see ``supply_named``.

    Raises:
        ConstructionError: it has another form; says where and what is accepted.
    """
    whole = _mapping(name, "the file", document, ("arena", "places"))
    arena = _arena(name, whole.get("arena", {}), start)
    listed = whole.get("places")
    if not isinstance(listed, list) or not 1 <= len(listed) <= _MOST_PLACES:
        raise ConstructionError(f"{name}: places: must be a list of 1 to {_MOST_PLACES} places")
    return Supply(arena, tuple(_place(name, number, each, arena) for number, each in enumerate(listed, 1)))


def supply_document(supply: Supply) -> Dict[str, Any]:
    """Give a supply as plain JSON; ``supply_of`` reads it."""
    arena = supply.arena
    return {
        "arena": {**{key: getattr(arena, key) for key in _ARENA_KEYS[:-1]}, "start": list(arena.start)},
        "places": [
            {
                "x": place.x,
                "y": place.y,
                "yaw": place.yaw,
                "blocks": {str(units): count for units, count in sorted(place.stock.items())},
            }
            for place in supply.places
        ],
    }


def _arena(name: str, found: object, start_of: Optional[_StartOf]) -> Arena:
    given = _mapping(name, "arena", found, _ARENA_KEYS)
    values: Dict[str, Any] = {
        key: _number(name, f"arena.{key}", given[key]) for key in _ARENA_KEYS[:-1] if key in given
    }
    if "start" in given:
        start = given["start"]
        if not isinstance(start, list) or len(start) != len("xy"):
            raise ConstructionError(f"{name}: arena.start: must be [x, y] in metres (found {_shown(start)})")
        values["start"] = tuple(_number(name, "arena.start", each) for each in start)
    elif start_of is not None:
        values["start"] = start_of(values.get("side", Arena.side))
    try:
        return Arena(**values)
    except ConstructionError as error:
        raise ConstructionError(f"{name}: {error}") from error


def _place(name: str, number: int, found: object, arena: Arena) -> SupplyPlace:
    where = f"places[{number - 1}]"
    given = _mapping(name, where, found, _PLACE_KEYS)
    missing = next((key for key in ("x", "y", "blocks") if key not in given), None)
    if missing is not None:
        raise ConstructionError(f"{name}: {where}: {missing}: missing; a place has x, y and blocks, and may have yaw")
    x, y = (_number(name, f"{where}.{key}", given[key]) for key in ("x", "y"))
    middle = arena.middle
    outward = math.atan2(y - middle.y, x - middle.x)
    yaw = _number(name, f"{where}.yaw", given["yaw"]) if "yaw" in given else outward
    if abs(yaw) > _MOST_TURNS * 2.0 * math.pi:
        raise ConstructionError(f"{name}: {where}.yaw: found {yaw:g} rad; accepted are {_MOST_TURNS} turns at most")
    return SupplyPlace(number, x, y, yaw, _stock(name, f"{where}.blocks", given["blocks"]))


def _stock(name: str, where: str, found: object) -> Dict[int, Optional[int]]:
    """Read lengths of blocks, as a list, or with how many there are."""
    pairs: Iterable[Tuple[object, Any]]
    if isinstance(found, list):
        pairs = [(each, None) for each in found]
    elif isinstance(found, dict):
        pairs = list(found.items())
    else:
        pairs = []
    stock: Dict[int, Optional[int]] = {}
    for units, count in pairs:
        length = _length(units)
        if length is None or length in stock or not (count is None or _is_count(count)):
            raise ConstructionError(
                f"{name}: {where}: found {_shown(units)}: {_shown(count)}; accepted are lengths of 1 to {LONGEST} "
                "units, each once, with how many there are (null: as many as are needed)"
            )
        stock[length] = count
    if not stock:
        raise ConstructionError(f"{name}: {where}: must be a list of lengths, or lengths with how many there are")
    return stock


def _length(found: Any) -> Optional[int]:
    """Read the length of a block, which JSON has as text where it is a key; None if it is none."""
    number = int(found) if isinstance(found, str) and re.fullmatch("[0-9]{1,2}", found) else found
    return number if _is_count(number) and 1 <= number <= LONGEST else None


def _is_count(value: Any) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and value >= 0


def _number(name: str, where: str, found: object) -> float:
    if isinstance(found, bool) or not isinstance(found, (int, float)) or not abs(found) < math.inf:
        raise ConstructionError(f"{name}: {where}: must be a finite number (found {_shown(found)})")
    try:
        return float(found)
    except OverflowError as error:
        raise ConstructionError(f"{name}: {where}: must be a finite number (found {_shown(found)})") from error


def _mapping(name: str, where: str, found: object, keys: Tuple[str, ...]) -> Dict[str, Any]:
    if not isinstance(found, dict):
        raise ConstructionError(f"{name}: {where}: must be a mapping of {', '.join(keys)} (found {_shown(found)})")
    unknown: List[object] = [key for key in found if key not in keys]
    if unknown:
        raise ConstructionError(f"{name}: {where}: {_shown(unknown[0])}: unknown; accepted are {', '.join(keys)}")
    return found


def _shown(value: object) -> str:
    """Show what was found in short: aliases may make a small file's values endless."""
    return reprlib.repr(value)
