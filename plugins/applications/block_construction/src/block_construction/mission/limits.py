"""What a robot with an arm cannot build, and arenas that it is not made for."""

from __future__ import annotations

from block_construction.diagram.block_set import BODY_HEIGHT
from block_construction.errors import ConstructionError
from block_construction.execution.arena import Arena
from rqt_mrta_py.hooks import ArmModel, RobotModel, Structure

__all__ = ["check_arena", "check_levels", "most_levels"]

_OVER = 0.01
"""A carried block passes so high over what is placed [m]."""
_EXACT = 1e-9


def check_arena(name: str, arena: Arena, model: RobotModel) -> None:
    """Make sure that ways in an arena are found for a robot as large as the one that drives them.

    Args:
        name: of the file that the arena comes from.
        arena: as it is given.
        model: of the robot.

    Raises:
        ConstructionError: the robot is larger than the arena says, or the grid coarser than the robot's radius.
    """
    if arena.robot_radius < model.radius - _EXACT:
        raise ConstructionError(
            f"{name}: arena: robot_radius: {arena.robot_radius:g} m; accepted is at least that of {model.name}, "
            f"{model.radius:g} m"
        )
    if arena.cell > model.radius + _EXACT:
        raise ConstructionError(
            f"{name}: arena: cell: {arena.cell:g} m; accepted is at most the radius of {model.name}, {model.radius:g} m"
        )


def most_levels(arm: ArmModel) -> int:
    """Tell how high a robot builds.

    A block hangs at the height that the raised arm has; it is carried over what is placed, lowered onto its slot from
    just above it, and fetched from the floor.

    Args:
        arm: of the robot.

    Returns:
        Levels; 0 if the arm does not even reach down to the floor.
    """
    carried = arm.height_at(arm.highest) - BODY_HEIGHT / 2.0
    levels = 0
    while (levels + 1) * BODY_HEIGHT + _OVER <= carried + _EXACT:
        if not all(_reaches(arm, height) for height in (BODY_HEIGHT / 2.0, BODY_HEIGHT * (levels + 0.5) + _OVER)):
            break
        levels += 1
    return levels


def check_levels(structure: Structure, arm: ArmModel, robot: str) -> None:
    """Make sure that a structure is not higher than a robot builds.

    Args:
        structure: what shall be built.
        arm: of the robot.
        robot: name of its model.

    Raises:
        ConstructionError: it is; names the first voxel that is too high.
    """
    most = most_levels(arm)
    for y, row in enumerate(structure.heights, 1):
        for x, height in enumerate(row, 1):
            if height > most:
                raise ConstructionError(
                    f"{structure.name}: voxel x {x}, y {y}, level {most + 1} is higher than {robot} builds, which is "
                    f"{most} levels ({structure.levels} are wanted)"
                )


def _reaches(arm: ArmModel, height: float) -> bool:
    try:
        arm.angle_at(height)
    except ValueError:
        return False
    return True
