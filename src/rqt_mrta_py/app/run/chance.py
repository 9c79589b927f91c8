"""Seeded chance: one generator for each robot and purpose, all from the run's seed."""

from __future__ import annotations

from enum import Enum

import numpy as np

__all__ = ["Purpose", "generator", "link_generator"]


class Purpose(Enum):
    """What a generator is for; those of one robot never share numbers."""

    AGENT = 1
    BEHAVIOUR = 2
    SENSORS = 3
    LINK = 4


def generator(seed: int, robot_id: str, purpose: Purpose) -> np.random.Generator:
    """Make a generator that depends on nothing but its arguments.

    It is keyed by the robot's id, not by its place in the team, so that adding a robot leaves the others' chance alone.

    Args:
        seed: of the run, not negative.
        robot_id: whose chance it is; empty for what belongs to no robot.
        purpose: what it is for.

    Returns:
        A generator of its own.
    """
    key = (purpose.value, *robot_id.encode("utf-8"))
    return np.random.Generator(np.random.PCG64(np.random.SeedSequence(entropy=seed, spawn_key=key)))


def link_generator(seed: int, sender: str, receiver: str) -> np.random.Generator:
    """Make the generator of what one robot sends to one other; as ``generator`` otherwise."""
    # No name that ROS accepts holds this sign.
    return generator(seed, f"{sender}>{receiver}", Purpose.LINK)
