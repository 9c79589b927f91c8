"""Missions in which nothing must be found: the example applications, and yards with trouble that does no harm."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Callable, Dict, Iterator, List, Mapping, NamedTuple, Sequence

import numpy as np

from rqt_mrta_py.app.bench.incidents.fault import event, pick
from rqt_mrta_py.app.bench.incidents.setting import ARCHITECTURES, Setting
from rqt_mrta_py.app.bench.incidents.yards import YARDS, YardKind
from rqt_mrta_py.hooks import Experiment
from rqt_mrta_py.model import RadioSetup, ScenarioEvent, ScenarioEventKind

__all__ = ["Harmless", "harmless_missions"]

_LEAST_TOLERANCE = 0.5
"""How far off a clock may be under every architecture [s]."""


class Harmless(NamedTuple):
    """A mission in which nothing must be found.

    Attributes:
        name: of it.
        experiment: that it is.
    """

    name: str
    experiment: Experiment


def harmless_missions(folder: Path, seeds: Sequence[int]) -> List[Harmless]:
    """List the missions.

    Args:
        folder: where yards are.
        seeds: one for each mission of each kind.
    """
    examples = [each for seed in seeds[: max(1, len(seeds) // 15)] for each in _examples(seed)]
    return [*examples, *_troubled(folder, seeds)]


def _examples(seed: int) -> Iterator[Harmless]:
    for (application, duration), architecture in product(_EXAMPLES.items(), ARCHITECTURES):
        experiment = Experiment(application, seed, architecture, duration=duration, world="planar", events=())
        yield Harmless(f"{application} under {architecture}, seed {seed}", experiment)


_EXAMPLES: Dict[str, float] = {"border_patrol": 60.0, "cleanup": 90.0, "target_visiting": 80.0}
"""How long each is looked at [s]."""


def _troubled(folder: Path, seeds: Sequence[int]) -> Iterator[Harmless]:
    kinds = [
        (kind, trouble, architecture)
        for kind, trouble, architecture in product(_KINDS, _TROUBLES, ARCHITECTURES)
        if (kind, trouble) != (YardKind.ERRANDS, _LOSSY)
    ]
    for number, seed in enumerate(seeds):
        # In large steps, for neighbours in the list are alike.
        kind, trouble, architecture = kinds[number * _STEP % len(kinds)]
        calm = Setting(kind, architecture, seed).experiment(folder)
        random = np.random.default_rng([seed, number])
        experiment = _TROUBLES[trouble](calm, YARDS[kind].robot_ids, random)
        yield Harmless(f"{kind.value} under {architecture}, seed {seed}: {trouble}", experiment)


_KINDS = (YardKind.WATCH, YardKind.ERRANDS)

_LOSSY = "one message in twenty lost"
"""Does harm where tasks end: under ALLIANCE, who has not heard that a task is done does it again."""

_STEP = 8
"""Has no factor in common with the number of kinds of missions, so that all of them come."""


def _clocks_off(calm: Experiment, robots: Sequence[str], random: np.random.Generator) -> Experiment:
    kind = ScenarioEventKind.ROBOT_CLOCK_SHIFTS
    return _with_events(
        calm,
        *(
            event(pick(random, 1.0, 20.0), kind, robot, offset=pick(random, -0.8, 0.8) * _LEAST_TOLERANCE)
            for robot in robots
        ),
    )


def _robots_slow(calm: Experiment, robots: Sequence[str], random: np.random.Generator) -> Experiment:
    kind = ScenarioEventKind.ROBOT_SLOWS
    return _with_events(
        calm, *(event(pick(random, 1.0, 20.0), kind, robot, factor=pick(random, 0.7, 1.0)) for robot in robots)
    )


def _radio_late(calm: Experiment, robots: Sequence[str], random: np.random.Generator) -> Experiment:
    return replace(
        calm, radio=RadioSetup("lossy", {"delay": pick(random, 0.0, 0.1), "jitter": pick(random, 0.0, 0.05)})
    )


def _radio_lossy(calm: Experiment, robots: Sequence[str], random: np.random.Generator) -> Experiment:
    return replace(calm, radio=RadioSetup("lossy", {"loss": 0.05}))


def _with_events(calm: Experiment, *events: ScenarioEvent) -> Experiment:
    return replace(calm, events=(*(calm.events or ()), *events))


_TROUBLES: Mapping[str, Callable[[Experiment, Sequence[str], np.random.Generator], Experiment]] = {
    "clocks a bit off": _clocks_off,
    "robots a bit slow": _robots_slow,
    "messages a bit late": _radio_late,
    _LOSSY: _radio_lossy,
}
"""7 pairs of trouble and yard under 5 architectures: 35 missions until one comes again, with another seed."""
