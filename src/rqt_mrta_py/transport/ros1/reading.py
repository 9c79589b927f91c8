"""All connections of a node, read in one thread, in the order in which their messages arrive.

rospy gives each connection a thread; a hundred of them wait for one another longer than reading takes.
"""

from __future__ import annotations

import logging
import os
import select
import struct
import threading
from collections import deque
from typing import Any, Callable, Deque, Dict, List, Mapping, NamedTuple, Sequence

from rqt_mrta_py.transport.ros1.door import rospy
from rqt_mrta_py.transport.ros1.raw import any_type

__all__ = ["Incoming", "Reader", "Taker"]

_log = logging.getLogger("rqt_mrta_py.transport")

_READ = 1 << 16
"""How much is read at once [bytes]."""

_READ_LARGE = 1 << 20
"""The same where one message is known to be larger [bytes]."""

_LARGEST = 1_000_000_000
"""Messages that say they are larger are none; the same limit holds in roscpp [bytes]."""

_size_at = struct.Struct("<I").unpack_from


class Taker(NamedTuple):
    """Who takes in the messages of one connection.

    Attributes:
        take: is told of messages that have arrived together, in their order; raises nothing.
        leave: is told that the connection has been closed; locks of rospy's may be held, so it must take none.
    """

    take: Callable[[Sequence[bytes]], None]
    leave: Callable[[], None]


class Incoming:
    """One connection with what has arrived of its next message.

    Args:
        transport: of rospy's, connected.
        take: see Taker.
    """

    __slots__ = ("_have", "_need", "_parts", "_recv", "_take", "socket", "transport")

    def __init__(self, transport: Any, take: Callable[[Sequence[bytes]], None]) -> None:
        self.transport = transport
        self.socket = transport.socket
        self._recv = self.socket.recv
        self._take = take
        # What the publisher sent right behind its header was read with it.
        buffer = transport.read_buff
        self._parts: List[bytes] = [buffer.getvalue()[: buffer.tell()]]
        self._have = len(self._parts[0])
        self._need = 4

    def begin(self) -> bool:
        """Hand on what was read with the header; tell whether the connection goes on."""
        return self._cut(self._parts[0])

    def read(self) -> bool:
        """Read what is there and hand on whole messages; tell whether the connection goes on."""
        try:
            data = self._recv(_READ if self._need <= _READ else _READ_LARGE)
        except (BlockingIOError, InterruptedError):
            return True
        except OSError:
            return False
        have = len(data)
        if not have:
            return False
        self.transport.stat_bytes += have
        if not self._have and have >= 4 and have == _size_at(data)[0] + 4:
            # Nearly always one message comes, and the whole of it.
            self.transport.stat_num_msg += 1
            self._take((data[4:],))
            return True
        if self._have:
            self._parts.append(data)
            self._have += have
            if self._have < self._need:
                return True
            data = b"".join(self._parts)
        return self._cut(data)

    def _cut(self, data: bytes) -> bool:
        """Hand on all messages that are whole, and keep the rest."""
        raws: List[bytes] = []
        at, end, need = 0, len(data), 4
        while end - at >= 4:
            (size,) = _size_at(data, at)
            if size > _LARGEST:
                _log.warning("topic=%s a message of %d bytes cannot be meant", self.transport.name, size)
                return False
            if end - at - 4 < size:
                need = size + 4
                break
            raws.append(data[at + 4 : at + 4 + size])
            at += size + 4
        self._parts = [data[at:]] if at < end else []
        self._have, self._need = end - at, need
        if raws:
            self.transport.stat_num_msg += len(raws)
            self._take(raws)
        return True


class Reader:
    """Reads what rospy has connected.

    Args:
        welcome: gives who takes in the messages of a connection to a topic, from the header of its publisher.
    """

    def __init__(self, welcome: Callable[[str, Mapping[str, str]], Taker]) -> None:
        self._welcome = welcome
        self._poll = select.epoll()
        self._incoming: Dict[int, Incoming] = {}
        self._adopted: Deque[Incoming] = deque()
        self._wake_out, self._wake_in = os.pipe()
        self._poll.register(self._wake_out, select.EPOLLIN)
        self._ended = False
        self._thread = threading.Thread(target=self._run, name="reader", daemon=True)

    def start(self) -> None:
        """Begin to read, and have rospy hand over connections instead of waiting for each in a thread."""
        module = rospy().impl.tcpros_pubsub
        module.TCPROSTransport = _handed_over(module.TCPROSTransport, self._adopt, self._forget)
        self._thread.start()

    def stop(self) -> None:
        """Read no more."""
        self._ended = True
        self._wake()

    def _adopt(self, transport: Any) -> None:
        transport.socket.setblocking(False)
        taker = self._welcome(transport.name, transport.header)
        transport.leave = taker.leave
        self._adopted.append(Incoming(transport, taker.take))
        self._wake()

    def _wake(self) -> None:
        os.write(self._wake_in, b"x")

    def _run(self) -> None:
        poll, known = self._poll.poll, self._incoming
        while not self._ended:
            for descriptor, _ in poll():
                incoming = known.get(descriptor)
                if incoming is not None:
                    if not incoming.read():
                        incoming.transport.close()
                elif descriptor == self._wake_out:
                    os.read(descriptor, 1 << 10)
                    self._admit()

    def _admit(self) -> None:
        while self._adopted:
            incoming = self._adopted.popleft()
            descriptor = incoming.socket.fileno()
            if descriptor < 0:
                continue
            self._incoming[descriptor] = incoming
            self._poll.register(descriptor, select.EPOLLIN)
            if not incoming.begin():
                incoming.transport.close()

    def _forget(self, transport: Any) -> None:
        """Look at a connection no more; a process that was forked may keep it open after it is closed here."""
        descriptor = transport.socket.fileno() if transport.socket is not None else -1
        if self._incoming.pop(descriptor, None) is not None:
            self._poll.unregister(descriptor)


def _handed_over(base: Any, adopt: Callable[[Any], None], forget: Callable[[Any], None]) -> Any:
    """Make a class of connections that are handed over once they stand."""

    def receive_loop(self: Any, callback: Any) -> None:
        if self.protocol.recv_data_class is not any_type():
            # Somebody else in this process uses rospy by himself.
            base.receive_loop(self, callback)
            return
        try:
            adopt(self)
        except (OSError, AttributeError):
            # It was closed meanwhile.
            self.close()

    def close(self: Any) -> None:
        leave = None if self.done else vars(self).get("leave")
        if leave is not None:
            forget(self)
        base.close(self)
        if leave is not None:
            leave()

    return type("HandedOver", (base,), {"receive_loop": receive_loop, "close": close})
