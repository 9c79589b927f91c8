"""What a node publishes, hears and serves, as its master shall know it, also after a restart."""

from __future__ import annotations

import logging
import threading
from enum import Enum
from typing import Any, Callable, Dict, List, Set, Tuple

from rqt_mrta_py.transport.ros1.connecting import connect_once
from rqt_mrta_py.transport.ros1.door import registration_listener, rospy
from rqt_mrta_py.transport.ros1.master import Master

__all__ = ["Registrations"]

_log = logging.getLogger("rqt_mrta_py.transport")


class _Kind(Enum):
    """Names of rospy's kinds, with the master's methods."""

    PUB = ("pub", "registerPublisher", "unregisterPublisher")
    SUB = ("sub", "registerSubscriber", "unregisterSubscriber")
    SRV = ("srv", "registerService", "unregisterService")

    def __init__(self, code: str, register: str, unregister: str) -> None:
        self.code = code
        self.register = register
        self.unregister = unregister


_KINDS = {kind.code: kind for kind in _Kind}

_Key = Tuple[_Kind, str]


class Registrations:
    """Takes over from rospy, which stops for as long as no master answers and forgets that one may be new.

    Args:
        wake: is called when there is something to tell the master, perhaps with rospy's locks held.
    """

    def __init__(self, wake: Callable[[], None]) -> None:
        self._wake = wake
        self._lock = threading.Lock()
        self._data: Dict[_Key, str] = {}
        self._told: Set[_Key] = set()
        self._gone: List[Tuple[_Kind, str, str]] = []
        ros = rospy()
        self._node_uri: str = ros.core.get_node_uri()
        listeners = ros.impl.registration.get_registration_listeners()
        manager_class = ros.impl.registration.RegManager
        self._manager: Any = next(each for each in listeners.listeners if isinstance(each, manager_class))
        connect_once(self._manager.handler)
        for name, uri in ros.impl.registration.get_service_manager().get_services():
            self._data[_Kind.SRV, name] = uri
            self._told.add((_Kind.SRV, name))
        ros.core.add_shutdown_hook(self._let_go)
        listeners.clear()
        listeners.add_listener(_listener(self._added, self._removed))

    @property
    def any_told(self) -> bool:
        """Whether the master should know this node."""
        return bool(self._told)

    def forget(self) -> None:
        """Take note that the master is a new one, which knows nothing of this node."""
        with self._lock:
            self._told.clear()
            self._gone.clear()

    def again(self, topic: str) -> None:
        """Ask the master at the next occasion who publishes a topic that this node hears."""
        with self._lock:
            self._told.discard((_Kind.SUB, topic))

    def tell(self, master: Master) -> None:
        """Tell the master what it does not know yet.

        Args:
            master: that is told.

        Raises:
            TransportError: it does not answer; what it was not told, it is told the next time.
        """
        while True:
            with self._lock:
                gone = self._gone.pop(0) if self._gone else None
                key = next((each for each in self._data if each not in self._told), None)
            if gone is not None:
                kind, name, data = gone
                master.ask(kind.unregister, name, data if kind is _Kind.SRV else self._node_uri)
            elif key is not None:
                self._register(master, key)
            else:
                return

    def _register(self, master: Master, key: _Key) -> None:
        kind, name = key
        done, text, publishers = master.ask(kind.register, name, self._data.get(key, ""), self._node_uri)
        if not done:
            _log.error("topic=%s the master refuses to register it: %s", name, text)
        elif kind is _Kind.SUB:
            self._manager.publisher_update(name, publishers)
        with self._lock:
            self._told.add(key)

    def _let_go(self, _reason: str) -> None:
        """Wake rospy's own thread once the node has ended, which would sleep half a second more."""
        with self._manager.cond:
            self._manager.cond.notify_all()

    def _added(self, name: str, data: str, code: str) -> None:
        with self._lock:
            self._data[_KINDS[code], name] = data
            self._told.discard((_KINDS[code], name))
        self._wake()

    def _removed(self, name: str, data: str, code: str) -> None:
        key = (_KINDS[code], name)
        with self._lock:
            self._data.pop(key, None)
            if key in self._told:
                self._told.discard(key)
                self._gone.append((*key, data))
        self._wake()


def _listener(added: Callable[[str, str, str], None], removed: Callable[[str, str, str], None]) -> Any:
    def reg_added(_self: Any, resolved_name: str, data_type_or_uri: str, reg_type: str) -> None:
        added(resolved_name, data_type_or_uri, reg_type)

    def reg_removed(_self: Any, resolved_name: str, data_type_or_uri: str, reg_type: str) -> None:
        removed(resolved_name, data_type_or_uri, reg_type)

    body = {"reg_added": reg_added, "reg_removed": reg_removed}
    return type("Listener", (registration_listener(),), body)()
