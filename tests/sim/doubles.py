"""Stand-ins for worlds and generators, for tests that are about neither."""

from __future__ import annotations

from typing import Dict, Iterable, Iterator, List, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.hooks import WorldSetup
from rqt_mrta_py.model import Twist


class StillWorld:
    """Keeps robots at their starts, remembers what was asked of it, and sees what it was told to see."""

    def __init__(self, seen: Optional[Iterable[float]] = None, lacks: Iterable[str] = ()) -> None:
        self.seen = None if seen is None else np.array(list(seen), dtype=np.float64)
        self.capabilities = frozenset({"contacts", "drive:differential", "freeze", "ranges"}) - frozenset(lacks)
        self.setup: Optional[WorldSetup] = None
        self.frozen: List[Tuple[str, bool]] = []
        self.commands: Dict[str, Twist] = {}
        self.steps = 0
        self.closed = 0

    def reset(self, setup: WorldSetup) -> None:
        self.setup = setup

    def freeze(self, robot: str, frozen: bool) -> None:
        self.frozen.append((robot, frozen))

    def command(self, robot: str, actuator: str, value: Twist) -> None:
        assert actuator == "base"
        self.commands[robot] = value

    def step(self) -> None:
        self.steps += 1

    def poses(self) -> np.ndarray:
        return np.array([(r.start.x, r.start.y, r.start.yaw) for r in self.setup.robots]).reshape(-1, 3)

    def ranges(self, robots: Sequence[str], bearings: np.ndarray, max_range: float) -> np.ndarray:
        seen = np.resize(self.seen, (len(robots), bearings.size))
        return np.where(seen > max_range, np.inf, seen)

    def close(self) -> None:
        self.closed += 1


class ScriptedRandom:
    """A generator whose normal draws are given, then zero."""

    def __init__(self, normals: Iterable[float] = ()) -> None:
        self._normals: Iterator[float] = iter(normals)

    def standard_normal(self, size: Optional[int] = None, out: Optional[np.ndarray] = None):
        if out is not None:
            out[:] = self.standard_normal(out.size).reshape(out.shape)
            return out
        if size is None:
            return next(self._normals, 0.0)
        return np.array([next(self._normals, 0.0) for _ in range(size)])

    def random(self, out: np.ndarray) -> np.ndarray:
        out[:] = 0.5
        return out
