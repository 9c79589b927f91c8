"""The laboratory: simulated missions for benchmarks, as many as they like, without bag and pictures."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Iterator, Mapping, Optional, Protocol, Sequence, Tuple

from rqt_mrta_py.model import MissionRecord, RadioSetup, ScenarioEvent

__all__ = ["Experiment", "Laboratory", "Trial"]


@dataclass(frozen=True)
class Experiment:
    """One mission to be simulated; what is None stays as the application has it.

    Attributes:
        application: a registered name.
        seed: of the run.
        architecture: a registered name.
        duration: at most [s]; the mission ends earlier once every task has ended.
        world: where.
        robots: how many of the application's robots take part, from the first; the same team for scenario and
            architecture.
        settings: parameters, as ``--set`` takes them: ``robot1/broadcast_rate=2``, or ``broadcast_rate=2`` for all.
        events: instead of the scenario's.
        radio: instead of the scenario's.
        tasks: ids of those that the mission has; the others are left out.
    """

    application: str
    seed: int
    architecture: Optional[str] = None
    duration: Optional[float] = None
    world: Optional[str] = None
    robots: Optional[int] = None
    settings: Tuple[str, ...] = ()
    events: Optional[Tuple[ScenarioEvent, ...]] = None
    radio: Optional[RadioSetup] = None
    tasks: Optional[Tuple[str, ...]] = None


@dataclass(frozen=True)
class Trial:
    """What came of an experiment.

    Attributes:
        experiment: that was carried out.
        record: what the supervisor knows in the end, statistics included.
        messages: how many were published, by type.
        processor_time: that the mission took [s].
    """

    experiment: Experiment
    record: MissionRecord
    messages: Mapping[str, int] = field(default_factory=dict)
    processor_time: float = 0.0


class Laboratory(Protocol):
    """Carries out experiments."""

    def trials(self, experiments: Sequence[Experiment]) -> Iterator[Trial]:
        """Carry experiments out, on all cores, and give what came of each, in their order.

        Raises:
            MrtaError: one cannot be carried out; names application and seed.
        """
        ...
