"""Links set up by hand."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np

from rqt_mrta_py.hooks import LinkSetup
from rqt_mrta_py.model import Pose


class Chance:
    """Makes one generator for each pair, remembers whom it was asked for."""

    def __init__(self, seed: int = 0) -> None:
        self._seed = seed
        self._made: Dict[Tuple[str, str], np.random.Generator] = {}

    @property
    def asked(self) -> List[Tuple[str, str]]:
        return list(self._made)

    def __call__(self, sender: str, receiver: str) -> np.random.Generator:
        pair = (sender, receiver)
        if pair not in self._made:
            self._made[pair] = np.random.default_rng([self._seed, *"->".join(pair).encode()])
        return self._made[pair]


class Scripted:
    """A generator whose uniform draws are given, four at a time."""

    def __init__(self, *draws: Tuple[float, float, float, float]) -> None:
        self._draws = iter(draws)

    def random(self, size: int) -> np.ndarray:
        assert size == 4
        return np.array(next(self._draws))


def link_setup(parameters: Dict[str, Any], random: Any = None, **places: Tuple[float, float]) -> LinkSetup:
    poses = {name: Pose(*place) for name, place in places.items()}
    return LinkSetup(("r1", "r2", "r3"), parameters, poses.get, random or Chance())
