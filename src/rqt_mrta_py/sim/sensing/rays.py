"""The rays that sensors want: checked once, and cast for all robots that want the same."""

from __future__ import annotations

from typing import TYPE_CHECKING, Dict, Hashable, List, Mapping, Optional, Protocol, Sequence, Tuple

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import RayPattern, World
from rqt_mrta_py.sim.world_answers import ranges_of
from rqt_mrta_py.wording import shown

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["MOST_RAYS", "Looker", "Rays", "cast_together"]

MOST_RAYS = 3600
"""What a sensor may want to be cast at once; ten rays a degree."""


class Rays:
    """Rays that a sensor wants cast whenever it measures.

    Attributes:
        pattern: bearings and length; its array is our own.
        key: equal for equal rays.

    Args:
        where: names the sensor, for messages.
        wanted: what it answered.

    Raises:
        SimError: these are no rays, or too many.
    """

    def __init__(self, where: str, wanted: object) -> None:
        self.pattern = _checked(where, wanted)
        self.key: Hashable = (self.pattern.max_range, self.pattern.bearings.tobytes())


class Looker(Protocol):
    """Who may want rays cast: from which robots, in which order."""

    @property
    def rays(self) -> Optional[Rays]:
        """The rays; None if it wants none."""
        ...

    @property
    def robots(self) -> Sequence[str]:
        """Ids of the robots that measure."""
        ...


def cast_together(name: str, world: World, due: Sequence[Looker]) -> Mapping[int, NDArray[np.float64]]:
    """Cast rays, asking the world once for all robots that want equal ones.

    Args:
        name: of the world.
        world: where the robots are.
        due: whose rays to cast; those that want none are left out.

    Returns:
        True distances by the place of their sensors in ``due`` [m], each of shape (robots, rays), not to be changed.

    Raises:
        SimError: the world answers what are no distances of these rays.
    """
    alike: Dict[Hashable, Tuple[RayPattern, List[int]]] = {}
    for place, one in enumerate(due):
        if one.rays is not None:
            alike.setdefault(one.rays.key, (one.rays.pattern, []))[1].append(place)
    seen: Dict[int, NDArray[np.float64]] = {}
    for pattern, places in alike.values():
        rows = ranges_of(name, world, [robot for place in places for robot in due[place].robots], pattern)
        rows.flags.writeable = False
        first = 0
        for place in places:
            seen[place] = rows[first : first + len(due[place].robots)]
            first += len(due[place].robots)
    return seen


def _checked(where: str, wanted: object) -> RayPattern:
    import numpy as np

    if not isinstance(wanted, RayPattern):
        raise SimError(f"{where}: its rays must be a RayPattern or None (got {shown(wanted)})")
    bearings, max_range = wanted
    try:
        taken = np.array(bearings, dtype=np.float64)
    except (TypeError, ValueError):
        raise SimError(f"{where}: its rays must have numbers for bearings (got {shown(bearings)})") from None
    if taken.ndim != 1 or taken.size > MOST_RAYS or not np.isfinite(taken).all():
        raise SimError(
            f"{where}: its rays must be a row of at most {MOST_RAYS} finite bearings (got shape {taken.shape})"
        )
    if not (isinstance(max_range, (int, float)) and 0.0 < max_range < np.inf):
        raise SimError(f"{where}: its rays must have a finite length above 0 m (got {max_range!r})")
    return RayPattern(taken, float(max_range))
