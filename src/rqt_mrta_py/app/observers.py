"""Message observers: told of messages, never allowed to stop anything."""

from __future__ import annotations

import logging
from typing import List, Mapping, Optional, Sequence

from rqt_mrta_py.app.guard import made, wishes_of
from rqt_mrta_py.hooks import Heard, Listener, MessageObserverFactory, ObserverSetup, Subscription
from rqt_mrta_py.hooks.manager import PluginManager
from rqt_mrta_py.hooks.patience import Patience
from rqt_mrta_py.model import Mission

__all__ = ["observers_of"]

_log = logging.getLogger("rqt_mrta_py.app")


class _IsolatedObserver:
    """An observer that hears no more once it has raised."""

    def __init__(self, name: str, factory: MessageObserverFactory, setup: ObserverSetup, patience: Patience) -> None:
        self._name = name
        self._who = f"message observer {name}"
        self._patience = patience
        self._observer: Optional[Listener] = None
        try:
            with patience.limit(self._who):
                self._observer = made(self._who, factory, setup, "subscriptions", "hear")
        except Exception:  # noqa: BLE001 - an observer never stops what it observes
            self._drop()

    def subscriptions(self) -> List[Subscription]:
        """Say what to hear; nothing if the observer cannot say it."""
        if self._observer is None:
            return []
        try:
            with self._patience.limit(self._who):
                return wishes_of(self._who, self._observer)
        except Exception:  # noqa: BLE001 - the same
            self._drop()
            return []

    def hear(self, heard: Heard) -> None:
        """Take in one message."""
        if self._observer is None:
            return
        try:
            with self._patience.limit(self._who):
                self._observer.hear(heard)
        except Exception:  # noqa: BLE001 - the same
            self._drop()

    def _drop(self) -> None:
        self._observer = None
        _log.exception("event=observer_failed observer=%s", self._name)


def observers_of(mission: Mission, manager: PluginManager) -> Sequence[Listener]:
    """Make every message observer that plugins register.

    Args:
        mission: as far as it is known.
        manager: plugins, loaded.

    Returns:
        In the order of their names; one that fails is logged by name and hears no more.
    """
    factories: Mapping[str, MessageObserverFactory] = manager.registered("mrta_register_message_observers")
    setup = ObserverSetup(mission)
    return [_IsolatedObserver(name, factories[name], setup, manager.patience) for name in sorted(factories)]
