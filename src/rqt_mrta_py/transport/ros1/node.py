"""A node of a ROS 1 graph: what it publishes, hears, serves and asks."""

from __future__ import annotations

import logging
import threading
from contextlib import nullcontext
from typing import Any, Callable, Dict, FrozenSet, List, Mapping, Optional, Sequence, Tuple

from rqt_mrta_py.hooks import AnyOutgoing, Codec, Heard, Stamped, Subscription
from rqt_mrta_py.transport.patterns import resolve_topic
from rqt_mrta_py.transport.ros1 import services
from rqt_mrta_py.transport.ros1.arguments import NodeArguments
from rqt_mrta_py.transport.ros1.asking import Asking
from rqt_mrta_py.transport.ros1.clock import CLOCK_TOPIC, RosClock
from rqt_mrta_py.transport.ros1.door import rospy, tell_rospy_the_time
from rqt_mrta_py.transport.ros1.hearing import Ears, Hearer
from rqt_mrta_py.transport.ros1.logs import ROSOUT, RosoutHandler
from rqt_mrta_py.transport.ros1.master import Master
from rqt_mrta_py.transport.ros1.misfits import Misfit, Misfits, watch_refusals
from rqt_mrta_py.transport.ros1.publishing import Mouths
from rqt_mrta_py.transport.ros1.reading import Reader
from rqt_mrta_py.transport.ros1.starting import become_node
from rqt_mrta_py.transport.ros1.watch import MasterChange, MasterWatch

__all__ = ["RosNode"]

_log = logging.getLogger("rqt_mrta_py.transport")

_PATIENCE = 5.0
"""How long to wait for somebody else who ends the node [s]."""


class RosNode(Asking):
    """This process as a node of a ROS 1 graph; made by ``start``, once in a process.

    Callbacks are called one at a time while the node's lock is held, those of messages in the order in which they
    arrive, in the one thread that reads them. What a callback raises ends the node: ``wait`` raises it again.

    Attributes:
        name: resolved.
        codec: reads and writes messages.
        lock: who touches what callbacks touch, in another thread, holds it meanwhile.
    """

    def __init__(self, codec: Codec, arguments: NodeArguments, master: Master, clock: RosClock) -> None:
        super().__init__(codec, arguments.remappings, master)
        self.lock = threading.RLock()
        self._clock = clock
        self._ending: Optional[threading.Thread] = None
        self._ended = threading.Event()
        self._failure: Optional[Exception] = None
        self._on_jump: List[Callable[[float, float], None]] = []
        self._on_master: List[Callable[[MasterChange], None]] = []
        self._on_misfit: List[Callable[[Misfit], None]] = []
        self._on_shutdown: List[Callable[[], None]] = []
        self._refused: Dict[str, Tuple[str, ...]] = {}
        misfits = Misfits(codec, self._misfit)
        self._ears = Ears(
            codec,
            self.lock,
            clock,
            on_connection=misfits.check,
            on_jump=self._jumped,
            on_failure=self._failed,
            on_lost=self._lost,
        )
        self._reader = Reader(self._ears.welcome)
        self._mouths = Mouths(codec, self.name, arguments)
        self._watch = MasterWatch(
            Master(master.uri, self.name), self.name, self._ears.offer, self._master_changed, self._failed
        )
        self._rosout = RosoutHandler(self.name, self.now, self._mouths.publish)

    @classmethod
    def start(
        cls,
        name: str,
        codec: Codec,
        *,
        anonymous: bool = False,
        arguments: Sequence[str] = (),
        await_master: bool = True,
        rosout: bool = True,
    ) -> RosNode:
        """Make this process a node; signals stay the program's.

        Args:
            name: without namespace; ``__name`` and ``__ns`` of the arguments, or ``ROS_NAMESPACE``, count first.
            codec: reads and writes messages.
            anonymous: whether to add to the name what makes it unique.
            arguments: remappings and private parameters as ROS writes them.
            await_master: whether to wait for a master that is not there yet.
            rosout: whether log lines of this process are published too; what callers publish there is.

        Raises:
            MissingDependencyError: ROS is not installed, or no master answers and is not waited for.
            TransportError: the name or an argument is none that ROS accepts, or the process is a node already.
        """
        given = NodeArguments.read(arguments)
        master = become_node(name, given, anonymous, await_master)
        simulated, _, value = master.ask("getParam", "/use_sim_time")
        node = cls(codec, given, master, RosClock(bool(simulated and value), tell_rospy_the_time))
        node._begin(rosout)
        return node

    @property
    def is_shut_down(self) -> bool:
        """Whether the node has ended or is about to."""
        return self._ending is not None

    def now(self) -> float:
        """Give ROS time [s]; where it is simulated, 0 before the first message of ``/clock``."""
        return self._clock.now()

    def subscribe(self, subscription: Subscription, callback: Callable[[Heard], None], latest: int = 1000) -> None:
        """Hear topics from now on, and the latched messages that they already have.

        Args:
            subscription: its topic is resolved and remapped; with tokens, topics are found through the master.
            callback: is told of each message; what cannot be read is logged once for each connection.
            latest: how many messages of a topic may wait to be heard; where several hear it, the most that any wants.

        Raises:
            TransportError: the topic is no name that ROS accepts.
        """
        topic = resolve_topic(subscription.topic, self.name, self._remappings)
        self._ears.subscribe(subscription._replace(topic=topic), callback, latest)
        self._watch.wake()

    def hear(
        self,
        wanted: Callable[[str, str], bool],
        callback: Callable[[Stamped], None],
        *,
        receipts: Optional[Callable[[], int]] = None,
    ) -> None:
        """Hear whole topics from now on as they are, and the latched messages that they already have.

        Args:
            wanted: tells of a topic and its type whether it is wanted; the type is empty while nobody knows it. It is
                asked again when the type changes, and should not take long.
            callback: is told of each message.
            receipts: gives the receipt of a message that arrives now [ns]; None: ROS time.
        """
        self._ears.add(Hearer(wanted, callback, receipts, "", None))
        self._watch.wake()

    def hear_topic(self, topic: str, callback: Callable[[Stamped], None]) -> None:
        """Hear one topic from now on as it is, whether anybody publishes it yet or not.

        Args:
            topic: resolved.
            callback: is told of each message.
        """
        self._ears.add(Hearer(lambda name, _type: name == topic, callback, None, topic, None))
        self._watch.wake()

    def pass_on(self, stamped: Stamped) -> None:
        """Publish a message that is written already, under this node's name.

        Args:
            stamped: its topic is resolved; whose it was and when it was received count for nothing.

        Raises:
            TransportError: this node publishes another type there.
        """
        self._mouths.pass_on(stamped)

    def hearers(self, topic: str) -> FrozenSet[str]:
        """Give the nodes that are connected to what this node publishes on a topic.

        Args:
            topic: resolved.
        """
        return self._mouths.hearers(topic)

    def refused(self, topic: str) -> FrozenSet[str]:
        """Give the nodes that were refused what this node publishes on a topic, for they take it for something else.

        Args:
            topic: resolved.
        """
        return frozenset(self._refused.get(topic, ()))

    def publish(self, outgoing: AnyOutgoing, now: float) -> None:
        """Publish a message, or many; they are written only if somebody hears them.

        Args:
            outgoing: topics are resolved and remapped.
            now: as for a node of the embedded bus; ROS tells nobody when a message was said.

        Raises:
            TransportError: a topic is no name that ROS accepts, this node publishes another type there, or a message
                does not fit its type; names node, topic and path.
        """
        self._mouths.publish(outgoing)

    def advertise(self, topic: str, type_name: str, latched: bool = False) -> None:
        """Let subscribers find a topic before the first message.

        Args:
            topic: is resolved and remapped.
            type_name: ``pkg/Msg``.
            latched: whether late subscribers get the last message.

        Raises:
            TransportError: as ``publish``.
        """
        self._mouths.mouth(topic, type_name, latched)

    def is_heard(self, topic: str, type_name: str, latched: bool = False) -> bool:
        """Tell whether a message would reach anybody, now or later; for what is costly to make.

        Args:
            topic: is resolved and remapped.
            type_name: ``pkg/Msg``.
            latched: whether late subscribers get the last message.

        Raises:
            TransportError: as ``publish``.
        """
        return self._mouths.mouth(topic, type_name, latched).is_heard

    def ask_again(self) -> None:
        """Ask all who hear whole topics anew what they want; for those who have changed their mind."""
        self._ears.ask_again()

    def serve(
        self,
        name: str,
        type_name: str,
        handler: Callable[[Mapping[str, Any]], Mapping[str, Any]],
        *,
        alone: bool = True,
    ) -> None:
        """Answer a service's requests from now on.

        Args:
            name: is resolved and remapped.
            type_name: ``pkg/Srv``; the codec knows it as ``pkg/SrvRequest`` and ``pkg/SrvResponse``.
            handler: from the fields of a request to those of its answer; an MrtaError refuses it with its one line.
            alone: whether the handler is called while the lock is held; else it takes the lock itself for what needs
                it, and messages are heard while it works.

        Raises:
            TransportError: the name or type is not known or accepted, or this node serves it already.
        """
        lock = self.lock if alone else nullcontext()
        services.serve(self.resolve(name), services.ServiceType.find(type_name, self.codec), self.codec, lock, handler)

    def log(self, level: int, text: str) -> None:
        """Say a line to people: on stderr and ``/rosout``, and in ROS's log file.

        Args:
            level: as of Python's logging.
            text: one line.
        """
        _log.log(level, "%s", text)

    def on_time_jump(self, callback: Callable[[float, float], None]) -> None:
        """Tell somebody when the clock goes backwards: the times before and after [s], before any later message."""
        self._on_jump.append(callback)

    def on_master(self, callback: Callable[[MasterChange], None]) -> None:
        """Tell somebody when the master is lost, found again or a new one."""
        self._on_master.append(callback)

    def on_misfit(self, callback: Callable[[Misfit], None]) -> None:
        """Tell somebody of connections whose two ends do not mean the same, once of each."""
        self._on_misfit.append(callback)

    def on_shutdown(self, callback: Callable[[], None]) -> None:
        """Tell somebody when the node ends, while it can still publish."""
        self._on_shutdown.append(callback)

    def shut_down(self, reason: str) -> None:
        """End the node; later calls do nothing.

        Args:
            reason: for the log.
        """
        rospy().signal_shutdown(reason)
        # Somebody else may be at it.
        if self._ending is not threading.current_thread():
            self._ended.wait(_PATIENCE)

    def wait(self, timeout: Optional[float] = None) -> bool:
        """Wait for the node's end, until all who are to be told of it have been and the master knows.

        Args:
            timeout: for how long at most [s]; None: for ever.

        Returns:
            Whether it has ended.

        Raises:
            Exception: what a callback raised.
        """
        ended = self._ended.wait(timeout)
        if self._failure is not None:
            raise self._failure
        return ended

    def _begin(self, rosout: bool) -> None:
        ros = rospy()
        ros.on_shutdown(self._end)
        ros.core.add_shutdown_hook(lambda _reason: self._ended.set())
        if rosout:
            self.advertise(*ROSOUT, latched=True)
            self._rosout.attach()
        self._reader.start()
        watch_refusals(self._refuse)
        if self._clock.simulated:
            self._ears.add(
                Hearer(lambda topic, _type: topic == CLOCK_TOPIC, lambda _stamped: None, None, CLOCK_TOPIC, None)
            )
        self._watch.start()

    def _end(self) -> None:
        self._ending = threading.current_thread()
        for callback in self._on_shutdown:
            try:
                with self.lock:
                    callback()
            except Exception as error:  # noqa: BLE001 - the others are told all the same
                self._failure = self._failure or error
                _log.error("node=%s at its end: %s", self.name, error)
        self._ears.closed = True
        self._reader.stop()
        self._watch.stop()
        self._rosout.close()

    def _failed(self, error: Exception) -> None:
        if self._failure is None:
            self._failure = error
        self._ears.closed = True
        # Not in the thread of a connection, which holds the lock and would be closed by it.
        threading.Thread(target=self.shut_down, args=(f"a callback failed: {error}",), daemon=True).start()

    def _jumped(self, before: float, after: float) -> None:
        for callback in self._on_jump:
            callback(before, after)

    def _master_changed(self, change: MasterChange) -> None:
        _log.warning("master=%s %s", self._master.uri, change.value)
        self._tell(self._on_master, change)

    def _lost(self, topic: str) -> None:
        self._watch.again(topic)

    def _refuse(self, misfit: Misfit) -> None:
        self._refused[misfit.topic] = (*self._refused.get(misfit.topic, ()), misfit.caller)
        self._misfit(misfit)

    def _misfit(self, misfit: Misfit) -> None:
        _log.warning("%s%s", misfit.text, f"\n{misfit.difference}" if misfit.difference else "")
        self._tell(self._on_misfit, misfit)

    def _tell(self, callbacks: Sequence[Callable[[Any], None]], news: object) -> None:
        with self.lock:
            try:
                for callback in callbacks:
                    callback(news)
            except Exception as error:  # noqa: BLE001 - as for messages
                self._failed(error)
