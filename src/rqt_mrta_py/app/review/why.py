"""Why tasks went to whom they went: hears grounds on the way, and explains the tasks that were asked about."""

from __future__ import annotations

import re
from collections import deque
from typing import Deque, Dict, List, Mapping, Pattern, Sequence, Tuple

from rqt_mrta_py.app.capabilities import known_capabilities
from rqt_mrta_py.app.guard import GuardedGrounds, made
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import GroundsReader, GroundsReaderFactory, GroundsSetup, Listener, RobotModel
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.hooks.patience import Patience
from rqt_mrta_py.model import Explanation, Ground, Mission, MissionRecord, TaskRecord, normalise_id
from rqt_mrta_py.supervisor import Explainer, OrderGrounds, bid_grounds
from rqt_mrta_py.wording import accepted, shown

__all__ = ["Why"]

_MOST_OF_EITHER = 1000
"""Of a task with many grounds so many of the first and of the last are kept."""


class _Kept:
    """The grounds of one task."""

    def __init__(self) -> None:
        self.count = 0
        self._first: List[Ground] = []
        self._last: Deque[Ground] = deque(maxlen=_MOST_OF_EITHER)

    def add(self, ground: Ground) -> None:
        self.count += 1
        (self._first if len(self._first) < _MOST_OF_EITHER else self._last).append(ground)

    @property
    def grounds(self) -> Sequence[Ground]:
        return (*self._first, *self._last)


class Why:
    """Collects what explains some tasks of a mission while its stream passes.

    Args:
        mission: as far as it is known.
        names: ids of tasks; ``*`` and ``?`` in them stand for any letters, and for any one.
        manager: plugins, loaded.
    """

    def __init__(self, mission: Mission, names: Sequence[str], manager: PluginManager) -> None:
        self._mission = mission
        self._names = tuple(dict.fromkeys(normalise_id(name) for name in names))
        self._patterns = [_pattern(name) for name in self._names]
        self._models: Mapping[str, RobotModel] = manager.registered("mrta_register_robot_models")
        self._kept: Dict[str, _Kept] = {}
        self._told_by = mission.architecture.package
        self._readers = self._guarded(manager)

    @property
    def is_asked(self) -> bool:
        """Tell whether there is anything to explain."""
        return bool(self._names)

    @property
    def listeners(self) -> Tuple[Listener, ...]:
        """Who is to hear the stream; nobody if nothing is asked."""
        return tuple(self._readers)

    @property
    def failures(self) -> Tuple[str, ...]:
        """What went wrong with readers of plugins, a line each."""
        return tuple(reader.failure for reader in self._readers if reader.failure)

    def explain(self, record: MissionRecord) -> Tuple[Explanation, ...]:
        """Explain the tasks that were asked about.

        Args:
            record: of the finished mission.

        Returns:
            In the record's order; without names of which there is no task.
        """
        chosen = [task for task in record.tasks if self._names_task(task.id)]
        explainer = Explainer(self._mission, record, known_capabilities(self._mission.scenario, self._models))
        return tuple(self._explained(explainer, task) for task in chosen)

    def check(self, record: MissionRecord, where: object) -> None:
        """Make sure that there is a task for each name.

        Args:
            record: of the finished mission.
            where: the outputs are, for the message.

        Raises:
            UsageError: there is none; names those that come close.
        """
        known = [task.id for task in record.tasks]
        for name, pattern in zip(self._names, self._patterns):
            if not any(pattern.fullmatch(task) for task in known):
                raise UsageError(
                    f"--why {shown(name)}: the mission has no such task; {accepted(name, known)}; "
                    f"all else was reviewed: {where}"
                )

    def _explained(self, explainer: Explainer, task: TaskRecord) -> Explanation:
        kept = self._kept.get(task.id, _Kept())
        grounds = kept.grounds
        return explainer.explain(task, grounds, kept.count - len(grounds), self._note(bool(grounds)))

    def _note(self, any_told: bool) -> str:
        if self.failures:
            return f"not all grounds were read: {self.failures[0]}"
        if not self._told_by:
            architecture = self._mission.architecture
            nobody = f"no plugin reads the grounds of {architecture.package}"
            if not architecture.bids:
                return nobody
            return f"but for bids, {nobody}" if any_told else f"nobody was heard to bid, and {nobody}"
        return "" if any_told else "what was heard tells none"

    def _guarded(self, manager: PluginManager) -> List[GuardedGrounds]:
        if not self._names:
            return []
        patience = manager.patience
        parts: List[GroundsReader] = [OrderGrounds(), *bid_grounds(self._mission.architecture)]
        readers = [self._reader("grounds that all share", part, patience) for part in parts]
        factories: Mapping[str, GroundsReaderFactory] = manager.registered("mrta_register_grounds_readers")
        factory = factories.get(self._told_by)
        if factory is None:
            self._told_by = ""
            return readers
        who = f"grounds reader of {self._told_by}"

        def make() -> GroundsReader:
            reader: GroundsReader = made(who, factory, GroundsSetup(self._mission), "subscriptions", "hear")
            return reader

        return [*readers, GuardedGrounds(who, make, patience, self._take)]

    def _reader(self, who: str, part: GroundsReader, patience: Patience) -> GuardedGrounds:
        return GuardedGrounds(who, lambda: part, patience, self._take)

    def _take(self, ground: Ground) -> None:
        if self._names_task(ground.task):
            if ground.task not in self._kept:
                self._kept[ground.task] = _Kept()
            self._kept[ground.task].add(ground)

    def _names_task(self, task: str) -> bool:
        return any(pattern.fullmatch(task) for pattern in self._patterns)


def _pattern(name: str) -> Pattern[str]:
    signs = {"*": ".*", "?": "."}
    return re.compile("".join(signs.get(letter, re.escape(letter)) for letter in name), re.DOTALL)
