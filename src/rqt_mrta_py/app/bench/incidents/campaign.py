"""Which missions there are, and carrying them out: first without faults, then with them."""

from __future__ import annotations

import zlib
from dataclasses import dataclass, field
from math import ceil
from pathlib import Path
from typing import Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from rqt_mrta_py.app.bench.experiments import ExperimentMissions
from rqt_mrta_py.app.bench.incidents.calm import CalmMission
from rqt_mrta_py.app.bench.incidents.fault import Fault, Strike
from rqt_mrta_py.app.bench.incidents.faults import FAULTS, faults_for
from rqt_mrta_py.app.bench.incidents.harmless import harmless_missions
from rqt_mrta_py.app.bench.incidents.judging import Verdict, judge
from rqt_mrta_py.app.bench.incidents.setting import ARCHITECTURES, Setting
from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.observation import pace_for
from rqt_mrta_py.hooks import Laboratory

__all__ = ["Campaign", "Judged", "carried_out", "chance"]

_MOST_TRIES = 8
"""How many missions are looked at for each that a fault is to strike."""


@dataclass(frozen=True)
class Campaign:
    """What is asked for.

    Attributes:
        rules: that are to be proved.
        first_seed: seeds count from there.
        missions: with a fault, for each rule, at the least; and likewise with trouble that does no harm.
        harmless: whether missions with such trouble, and of the examples, are carried out too.
    """

    rules: Tuple[str, ...]
    first_seed: int
    missions: int
    harmless: bool = True

    @property
    def counts(self) -> Dict[Fault, int]:
        """Give how many missions each fault strikes; the faults of a rule share its missions."""
        counts: Dict[Fault, int] = {}
        for rule in self.rules:
            faults = faults_for(rule)
            for fault in faults:
                counts[fault] = max(counts.get(fault, 0), ceil(self.missions / len(faults)))
        return {fault: counts[fault] for fault in FAULTS if fault in counts}

    def settings(self, fault: Fault) -> Iterator[Setting]:
        """Give the missions that a fault could strike: architecture after architecture, seed after seed."""
        for number in range(_MOST_TRIES * self.counts[fault]):
            turn, place = divmod(number, len(fault.architectures))
            yield Setting(fault.kind, fault.architectures[place], self.first_seed + turn)


class Judged(NamedTuple):
    """A mission that was carried out.

    Attributes:
        name: of it.
        fault: that struck; None: none did.
        verdict: on what was found.
    """

    name: str
    fault: Optional[Fault]
    verdict: Verdict


@dataclass
class _Search:
    """A fault's missions, as far as they have been found."""

    fault: Fault
    needed: int
    settings: Iterator[Setting]
    found: List[Tuple[CalmMission, Strike]] = field(default_factory=list)

    def next_settings(self) -> List[Setting]:
        """Give as many further missions as are lacking."""
        return [setting for _, setting in zip(range(self.needed - len(self.found)), self.settings)]


def carried_out(campaign: Campaign, host: Host, laboratory: Laboratory, folder: Path) -> Iterator[Judged]:
    """Carry all missions of a campaign out, and judge them.

    Args:
        campaign: what is asked for.
        host: registry and plugins.
        laboratory: carries missions out.
        folder: for the yards.
    """
    calm: Dict[Setting, CalmMission] = {}
    searches = [_Search(fault, count, campaign.settings(fault)) for fault, count in campaign.counts.items()]
    while True:
        asked = [(search, search.next_settings()) for search in searches]
        if not any(settings for _, settings in asked):
            break
        new = dict.fromkeys(each for _, settings in asked for each in settings if each not in calm)
        calm.update(_calm_missions(tuple(new), host, laboratory, folder))
        for search, settings in asked:
            for setting in settings:
                strike = search.fault.strike(calm[setting], chance(search.fault, setting))
                if strike is not None:
                    search.found.append((calm[setting], strike))
    for mission in calm.values():
        yield Judged(_name(mission.setting), None, judge(mission.record.incidents, (), ()))
    if campaign.harmless:
        seeds = range(campaign.first_seed, campaign.first_seed + campaign.missions)
        harmless = harmless_missions(folder, seeds)
        for each, trial in zip(harmless, laboratory.trials([each.experiment for each in harmless])):
            yield Judged(each.name, None, judge(trial.record.incidents, (), ()))
    struck = [(search.fault, mission, strike) for search in searches for mission, strike in search.found]
    experiments = [strike.applied(mission.experiment) for _, mission, strike in struck]
    for (fault, mission, strike), trial in zip(struck, laboratory.trials(experiments)):
        verdict = judge(trial.record.incidents, strike.labels, strike.allowances)
        yield Judged(f"{fault.name}: {_name(mission.setting)}", fault, verdict)


def chance(fault: Fault, setting: Setting) -> np.random.Generator:
    """Make the generator that decides what a fault does to a mission; it depends on these two alone."""
    name = zlib.crc32(fault.name.encode("utf-8"))
    return np.random.default_rng([name, ARCHITECTURES.index(setting.architecture), setting.seed])


def _calm_missions(
    settings: Sequence[Setting], host: Host, laboratory: Laboratory, folder: Path
) -> Iterator[Tuple[Setting, CalmMission]]:
    missions = ExperimentMissions(host)
    experiments = [setting.experiment(folder) for setting in settings]
    for setting, trial in zip(settings, laboratory.trials(experiments)):
        mission, _ = missions.prepare(trial.experiment)
        pace = pace_for(mission, host.manager)
        yield setting, CalmMission(setting, trial.experiment, mission, pace, trial.record)


def _name(setting: Setting) -> str:
    return f"{setting.kind.value} under {setting.architecture}, seed {setting.seed}"
