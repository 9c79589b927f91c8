"""What a world answers, checked: worlds come from plugins, and what is amiss is told with the world's name."""

from __future__ import annotations

from typing import TYPE_CHECKING, FrozenSet, Sequence, Tuple

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import RayPattern, World
from rqt_mrta_py.wording import shown

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["capabilities_of", "poses_of", "ranges_of"]


def capabilities_of(name: str, world: World) -> FrozenSet[str]:
    """Ask a world what it can do.

    Args:
        name: of the world.
        world: to be asked.

    Raises:
        SimError: it answers no set of texts.
    """
    told: object = world.capabilities
    if isinstance(told, (frozenset, set)) and all(isinstance(capability, str) for capability in told):
        return frozenset(told)
    raise SimError(f"world {name}: capabilities answered {shown(told)}; accepted is a frozenset of texts")


def poses_of(name: str, world: World, robots: Sequence[str]) -> NDArray[np.float64]:
    """Ask a world where its robots are.

    Args:
        name: of the world.
        world: to be asked.
        robots: all of its robots, in the setup's order.

    Returns:
        True poses in the frame ``map``: x, y [m] and yaw [rad], shape (robots, 3).

    Raises:
        SimError: it answers another array than (robots, 3), or no finite poses.
    """
    import numpy as np

    poses = _array(f"world {name}: poses", world.poses(), (len(robots), 3))
    finite = np.isfinite(poses).all(axis=1)
    if not finite.all():
        first = int(finite.argmin())
        raise SimError(f"world {name}: poses answered {poses[first].tolist()} for {robots[first]}; accepted are finite")
    return poses


def ranges_of(name: str, world: World, robots: Sequence[str], rays: RayPattern) -> NDArray[np.float64]:
    """Ask a world what rays meet.

    Args:
        name: of the world.
        world: to be asked.
        robots: from whose centres.
        rays: that each of them casts.

    Returns:
        True distances [m], shape (robots, rays); infinity where nothing is seen.

    Raises:
        SimError: it answers another array, or what are no distances.
    """
    who = f"world {name}: ranges"
    answer = world.ranges(robots, rays.bearings, rays.max_range)
    rows = _array(who, answer, (len(robots), rays.bearings.size))
    if not (rows >= 0.0).all():
        amiss = float(rows[~(rows >= 0.0)][0])
        raise SimError(f"{who} answered {amiss!r} m; accepted are 0 m and above")
    return rows


def _array(who: str, answer: object, shape: Tuple[int, ...]) -> NDArray[np.float64]:
    import numpy as np

    if not (isinstance(answer, np.ndarray) and answer.dtype == np.float64):
        raise SimError(f"{who} answered {shown(answer)}; accepted is an array of float64 of shape {shape}")
    if answer.shape != shape:
        raise SimError(f"{who} answered an array of shape {answer.shape}; accepted is {shape}")
    return answer
