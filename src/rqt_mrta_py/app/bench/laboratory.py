"""The laboratory: experiments carried out as simulated missions, on all cores."""

from __future__ import annotations

from typing import Callable, Dict, Iterator, Optional, Sequence, Tuple, TypeVar

from rqt_mrta_py.app.bench.apart import apart
from rqt_mrta_py.app.bench.experiments import ExperimentMissions
from rqt_mrta_py.app.bench.workers import in_order
from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.processes import cores
from rqt_mrta_py.app.run.collector import rare_collections
from rqt_mrta_py.errors import MrtaError
from rqt_mrta_py.hooks import Experiment, IdleTeam, TeamCost, Trial

__all__ = ["EmbeddedLaboratory", "ExperimentError"]

_Item = TypeVar("_Item")
_Outcome = TypeVar("_Outcome")


class ExperimentError(MrtaError):
    """An experiment cannot be carried out."""


class EmbeddedLaboratory:
    """Carries experiments out in processes of this machine; implements Laboratory.

    What comes of an experiment depends on it alone, save for the processor time: not on the other experiments, nor on
    how many processes share the work.

    Args:
        host: registry and plugins.
        processes: that share the work; 1: it is done in this one. None: as many as there are cores.
        progress: is told how many experiments of one call have been carried out, and how many there are.
    """

    def __init__(
        self,
        host: Host,
        processes: Optional[int] = None,
        progress: Callable[[float, float], None] = lambda done, planned: None,
    ) -> None:
        self._host = host
        self._processes = cores() if processes is None else processes
        self._progress = progress

    def trials(self, experiments: Sequence[Experiment]) -> Iterator[Trial]:
        """Carry experiments out, and give what came of each, in their order.

        Who stops listening, by an exception or for good, ends the processes.

        Raises:
            ExperimentError: one cannot be carried out; names application and seed.
        """
        missions = ExperimentMissions(self._host)

        def carry_out(experiment: Experiment) -> Trial:
            return _carried_out(missions, experiment)

        yield from self.outcomes(carry_out, experiments)

    def costs(self, teams: Sequence[IdleTeam]) -> Iterator[TeamCost]:
        """Measure what teams cost, one after the other, each in a process of its own, in their order."""
        self._progress(0.0, float(len(teams)))
        for number, team in enumerate(teams, start=1):
            try:
                messages, processor_time = apart(_cost_of, self._host, team)
            except MrtaError as error:
                told = ExperimentError(f"{team.architecture}, {len(team.parameters)} idle robots: {error}")
                told.exit_code = error.exit_code
                raise told from error
            self._progress(float(number), float(len(teams)))
            yield TeamCost(team, messages, processor_time)

    def outcomes(self, work: Callable[[_Item], _Outcome], items: Sequence[_Item]) -> Iterator[_Outcome]:
        """Do work of any other kind on all cores, piece by piece, and give what came of each, in their order.

        Who stops listening, by an exception or for good, ends the processes.
        """
        self._progress(0.0, float(len(items)))
        for number, outcome in enumerate(in_order(work, items, self._processes), start=1):
            self._progress(float(number), float(len(items)))
            yield outcome


def _cost_of(host: Host, team: IdleTeam) -> Tuple[Dict[str, int], float]:
    from rqt_mrta_py.app.bench.idle_team import cost_of

    return cost_of(host, team)


def _carried_out(missions: ExperimentMissions, experiment: Experiment) -> Trial:
    # The simulator is loaded only where something is simulated: other benchmarks come without.
    from rqt_mrta_py.app.bench.trial import carry_out

    try:
        mission, duration = missions.prepare(experiment)
        with rare_collections():
            return carry_out(missions.host, experiment, mission, duration)
    except MrtaError as error:
        told = ExperimentError(f"{experiment.application}, seed {experiment.seed}: {error}")
        told.exit_code = error.exit_code
        raise told from error
