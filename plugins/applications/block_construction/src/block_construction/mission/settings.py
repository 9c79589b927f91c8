"""What can be set of a build."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import FrozenSet, Mapping, Optional, Sequence

from block_construction.execution.planners import METHODS
from rqt_mrta_py.hooks import MissionSetting, UsageError

__all__ = ["ORDERS", "SETTINGS", "BuildSettings", "read_build_settings"]

ORDERS = ("plan", "free")
_LARGEST_NOISE = 0.5
_LONGEST_HOLD = 86400.0
_FOR_EACH_SOURCE = {
    "plan": ("structure", "diagram", "method", "supply", "planner"),
    "diagram": ("structure", "method"),
}
"""What says the same otherwise, and cannot be given beside."""

SETTINGS = (
    MissionSetting("structure", "what is built: the name of a structure, or a .vox, .npy or .txt file", "wall"),
    MissionSetting("diagram", "a diagram.json of mrta plan-structure, in place of a structure"),
    MissionSetting("plan", "a plan.json of mrta plan-build, in place of structure, supply and planning"),
    MissionSetting(
        "method", "which block where: an assembly planner; default: the wall as the source has it, else exact, or pla"
    ),
    MissionSetting(
        "supply", "corners, corners_all, wall_source (the source's place for the wall), or a file", "corners"
    ),
    MissionSetting(
        "planner",
        f"in which order: {', '.join(sorted(METHODS))}; default: exact; local if groups are large or supply is short",
    ),
    MissionSetting("order", "plan (one block after the other) or free (what must lie before); default: by robots"),
    MissionSetting("pose_noise", "x and y that a robot is told are off by up to so much [m]", "0"),
    MissionSetting("pose_hold", "for so long such an error lasts [s]; 0: each pose has its own", "0"),
    MissionSetting("sight_noise", "standard deviation of where a robot sees blocks, in x and in y [m]", "0"),
    MissionSetting("seed", "of all chance in planning", "0"),
)


@dataclass(frozen=True)
class BuildSettings:
    """What is set.

    Attributes:
        structure: name or path.
        diagram: path; empty for none.
        plan: path; empty for none.
        method: name of an assembly planner; empty for the usual one.
        supply: name or path.
        planner: name of a method of planning builds; empty for the usual one.
        order: ``plan`` or ``free``.
        pose_noise: greatest error of a robot's x and y [m].
        pose_hold: how long one such error lasts [s]; 0: each pose has its own.
        sight_noise: standard deviation of where a robot sees blocks, in x and in y [m].
        seed: of all chance in planning.
        given: names of those that the user has given.
    """

    structure: str
    diagram: str
    plan: str
    method: str
    supply: str
    planner: str
    order: str
    pose_noise: float
    pose_hold: float
    sight_noise: float
    seed: int
    given: FrozenSet[str]


def read_build_settings(values: Mapping[str, str], given: FrozenSet[str], robots: int) -> BuildSettings:
    """Read what is set.

    Args:
        values: of all settings, by name.
        given: names of those that the user has given.
        robots: how many take part; one follows a plan, several are free, unless it is set.

    Raises:
        UsageError: a value makes no sense, or two exclude each other; says what is accepted.
    """
    for name, others in _FOR_EACH_SOURCE.items():
        clash = next((other for other in others if other in given), None)
        if values[name] and clash is not None:
            raise UsageError(f"{name}={values[name]}: says already what {clash}={values[clash]} does; give one of them")
    order = _one_of("order", values["order"], ORDERS) or ("plan" if robots == 1 else "free")
    planner = _one_of("planner", values["planner"], sorted(METHODS)) or ""
    if planner and order == "free":
        raise UsageError(
            f"planner={planner}: plans an order, and with order=free (usual of teams) there is none; give order=plan "
            "or no planner"
        )
    return BuildSettings(
        structure=values["structure"],
        diagram=values["diagram"],
        plan=values["plan"],
        method=values["method"],
        supply=values["supply"],
        planner=planner,
        order=order,
        pose_noise=_number("pose_noise", values["pose_noise"], _LARGEST_NOISE, "m"),
        pose_hold=_number("pose_hold", values["pose_hold"], _LONGEST_HOLD, "s"),
        sight_noise=_number("sight_noise", values["sight_noise"], _LARGEST_NOISE, "m"),
        seed=_seed(values["seed"]),
        given=given,
    )


def _one_of(name: str, value: str, known: Sequence[str]) -> Optional[str]:
    if not value:
        return None
    if value not in known:
        raise UsageError(f"{name}={value}: there is no such {name}; accepted are {', '.join(known)}")
    return value


def _number(name: str, text: str, largest: float, unit: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not 0.0 <= number <= largest:
        raise UsageError(f"{name}={text}: a number from 0 to {largest:g} {unit} is expected")
    return number


def _seed(text: str) -> int:
    try:
        seed = int(text)
    except ValueError:
        seed = -1
    if not 0 <= seed < 2**63:
        raise UsageError(f"seed={text}: a whole number from 0 to 2^63 - 1 is expected")
    return seed
