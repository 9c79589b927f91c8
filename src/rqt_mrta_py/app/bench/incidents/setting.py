"""Settings: a kind of yard, an architecture, a seed; and the missions that they make."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Mapping, NamedTuple, Tuple

from rqt_mrta_py.app.bench.incidents.yards import EXPECTED_DURATION, SENTINEL, YARDS, YardKind, write_yard
from rqt_mrta_py.hooks import Experiment
from rqt_mrta_py.model import ScenarioEvent, ScenarioEventKind

__all__ = ["ALLIANCE", "ARCHITECTURES", "BASELINES", "DEMIR_CF", "DURATIONS", "L_ALLIANCE", "NEAREST_ROBOT", "Setting"]

ALLIANCE, L_ALLIANCE = "mrta_alliance", "mrta_l_alliance"
DEMIR_CF = "mrta_demir_cf"
NEAREST_ROBOT, BASELINES = "nearest_robot", "mrta_baselines"

ARCHITECTURES = (ALLIANCE, L_ALLIANCE, DEMIR_CF, NEAREST_ROBOT, BASELINES)

DURATIONS: Mapping[YardKind, float] = {
    YardKind.WATCH: 64.0,
    YardKind.ERRANDS: 80.0,
    YardKind.DEADLINES: 80.0,
    YardKind.ARRIVALS: 128.0,
}
"""Of missions [s]."""

_ARRIVAL_PERIOD = 22.0
"""Between two tasks that come up [s]: twice what the longest way takes, so that all robots are free again."""

_LAST = 0.5

_BEHAVIOUR_SET = "behaviour_sets/behaviour_set@index@/"

_TOLD = (
    "spin_rate=1",
    f"{_BEHAVIOUR_SET}motivational_behaviour/impatience/fast_rate=5",
    f"{_BEHAVIOUR_SET}task_expected_duration={2.0 * EXPECTED_DURATION}",
)
"""ALLIANCE's robots are patient with others for as many cycles as these expect a task to take [s]."""


class Setting(NamedTuple):
    """A mission before anything happens in it.

    Attributes:
        kind: of the yard.
        architecture: package.
        seed: of the yard, and of the mission.
    """

    kind: YardKind
    architecture: str
    seed: int

    def experiment(self, folder: Path) -> Experiment:
        """Make the mission.

        Args:
            folder: where yards are; that of this setting is written if need be.
        """
        experiment = Experiment(
            write_yard(folder, self.kind, self.seed),
            self.seed,
            architecture=self.architecture,
            duration=DURATIONS[self.kind],
            world="planar",
            events=_events(self.kind),
        )
        if self.architecture == ALLIANCE and self.kind is YardKind.DEADLINES:
            experiment = replace(experiment, settings=_TOLD)
        return experiment


def _events(kind: YardKind) -> Tuple[ScenarioEvent, ...]:
    appears = ScenarioEventKind.TASK_APPEARS
    if kind is YardKind.ARRIVALS:
        later = enumerate(YARDS[kind].tasks[1:], 1)
        return tuple(ScenarioEvent(number * _ARRIVAL_PERIOD, appears, task=task) for number, task in later)
    if YARDS[kind].sentinel:
        return (ScenarioEvent(DURATIONS[kind] - _LAST, appears, task=SENTINEL),)
    return ()
