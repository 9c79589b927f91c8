"""The laboratory: simulated missions for benchmarks, as many as they like, without bag and pictures; idle teams."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Iterator, Mapping, Optional, Protocol, Sequence, Tuple, TypeVar

from rqt_mrta_py.hooks.agent import Agent, AgentSetup
from rqt_mrta_py.model import MapKnowledge, MissionRecord, RadioSetup, ScenarioEvent

__all__ = ["AgentChange", "Experiment", "IdleTeam", "Laboratory", "TeamCost", "Trial"]

AgentChange = Callable[[AgentSetup, Agent], Agent]
"""From what an agent was made of, and the agent, to the one that takes its place: perhaps one that misbehaves."""

_Item = TypeVar("_Item")
_Outcome = TypeVar("_Outcome")


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
        settings: parameters, as ``--set`` takes them: ``robot1/broadcast_rate=2``, or ``broadcast_rate=2`` for all; and
            settings of the application's maker of missions.
        events: instead of the scenario's.
        radio: instead of the scenario's.
        tasks: ids of those that the mission has; the others are left out.
        map: whether robots know it from the start.
        agents: changes each of them, in the team's order; a value that can be sent to another process.
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
    map: Optional[MapKnowledge] = None
    agents: Optional[AgentChange] = None


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


@dataclass(frozen=True)
class IdleTeam:
    """A team whose agents work and whose behaviours are always applicable and do nothing, for what agents cost.

    There is no world, every message arrives at once, and nobody records or supervises.

    Attributes:
        architecture: a registered name, whose agents they are.
        parameters: by robot, in the team's order: what its agent is told, complete; see AgentSetup.
        tasks: ids of the tasks, which never end and which every robot may carry out.
        duration: that is measured [s].
        warm_up: that passes before [s].
        control_rate: control ticks a second [Hz].
    """

    architecture: str
    parameters: Mapping[str, Mapping[str, Any]]
    tasks: Tuple[str, ...]
    duration: float
    warm_up: float = 0.0
    control_rate: int = 10


@dataclass(frozen=True)
class TeamCost:
    """What an idle team cost.

    Attributes:
        team: that was measured.
        messages: how many were published in its duration, by type.
        processor_time: that its duration took [s].
    """

    team: IdleTeam
    messages: Mapping[str, int]
    processor_time: float


class Laboratory(Protocol):
    """Carries out experiments and other work on all cores, and measures what agents cost."""

    def trials(self, experiments: Sequence[Experiment]) -> Iterator[Trial]:
        """Carry experiments out, on all cores, and give what came of each, in their order.

        Raises:
            MrtaError: one cannot be carried out; names application and seed.
        """
        ...

    def costs(self, teams: Sequence[IdleTeam]) -> Iterator[TeamCost]:
        """Measure what teams cost, one after the other, each in a process of its own, in their order.

        Raises:
            MrtaError: a team cannot be made, or fails; names architecture and team.
        """
        ...

    def outcomes(self, work: Callable[[_Item], _Outcome], items: Sequence[_Item]) -> Iterator[_Outcome]:
        """Do work of any other kind on all cores, piece by piece, and give what came of each, in their order.

        Args:
            work: of one item; its outcome depends on the item alone, and can be pickled. What is loaded or compiled
                beforehand, all processes have.
            items: any that work takes.

        Raises:
            BaseException: what the work raised for the first item, in their order, for which it raised.
        """
        ...
