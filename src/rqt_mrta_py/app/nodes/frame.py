"""What all nodes share: from arguments to an exit status that suits ``required`` and ``respawn``."""

from __future__ import annotations

import logging
import signal
import sys
from contextlib import contextmanager
from types import FrameType
from typing import Any, Callable, Dict, Iterator, List, Optional, Sequence

from rqt_mrta_py.app.cli.logs import start_logging
from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.errors import MrtaError
from rqt_mrta_py.transport.ros1 import RosNode
from rqt_mrta_py.wording import printable

__all__ = ["Ending", "node_main"]

_log = logging.getLogger("rqt_mrta_py.app")

_LOOK = 0.2
"""How often a waiting program looks whether it shall end [s]."""


class Ending:
    """Knows whether a node shall end: SIGINT, SIGTERM, ``rosnode kill``, or what a callback raised.

    Attributes:
        requested: True once a signal asked for it; a second one interrupts as usual.

    Args:
        node: that ends.
    """

    def __init__(self, node: RosNode) -> None:
        self.requested = False
        self._node = node

    def wait(self, timeout: Optional[float] = None) -> bool:
        """Wait for the end.

        Args:
            timeout: for how long at most [s]; None: for ever.

        Returns:
            Whether it has come.

        Raises:
            Exception: what a callback raised.
        """
        left = float("inf") if timeout is None else timeout
        while not self.requested:
            if self._node.wait(min(_LOOK, max(left, 0.0))):
                return True
            left -= _LOOK
            if left <= 0.0:
                return self.requested
        return True

    @contextmanager
    def heeding_signals(self) -> Iterator[None]:
        """Take the signals that end programs as a wish to end; in the main thread."""
        before: Dict[int, Any] = {}

        def note(_number: int, _frame: Optional[FrameType]) -> None:
            self.requested = True
            for number, handler in before.items():
                signal.signal(number, handler)

        for asked in (signal.SIGINT, signal.SIGTERM):
            before[asked] = signal.signal(asked, note)
        try:
            yield
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)


def node_main(
    name: str,
    work: Callable[[RosNode, Host, Ending], None],
    argv: Optional[Sequence[str]] = None,
    host: Optional[Host] = None,
    level: int = logging.INFO,
    **how: Any,
) -> int:
    """Run a node until it ends.

    Args:
        name: of the node, unless its arguments say another.
        work: of the node; returns when it is done or its ending says so.
        argv: arguments without the program's name; None for the process's own.
        host: registry and plugins; None: they are looked for.
        level: from which on this project's log lines are told.
        how: further arguments of ``RosNode.start``.

    Returns:
        The exit status: 0 for a clean end, asked for or not; else as ``mrta`` does.
    """
    arguments: List[str] = list(sys.argv[1:] if argv is None else argv)
    start_logging(0, 0)
    logging.getLogger("rqt_mrta_py").setLevel(level)
    node: Optional[RosNode] = None
    try:
        if host is None:
            host = compose(forgiving=True)
            for problem in host.problems:
                _log.warning("%s", problem)
        node = RosNode.start(name, host.codec(), arguments=arguments, **how)
        ending = Ending(node)
        with ending.heeding_signals():
            work(node, host, ending)
        return 0
    except MrtaError as error:
        for line in str(error).splitlines():
            sys.stderr.write(f"{name}: {printable(line)}\n")
        return error.exit_code
    except KeyboardInterrupt:
        return 130
    except Exception as error:  # noqa: BLE001 - the last border: a defect of ours is told in one line too
        _log.debug("node=%s", name, exc_info=True)
        sys.stderr.write(f"{name}: internal error: {type(error).__name__}: {printable(str(error))}\n")
        return 70
    finally:
        if node is not None:
            node.shut_down(f"{name} has ended")
