"""Patience: nobody waits for ever for a plugin's answer.

The operating system's alarm interrupts Python code of the main thread. Code that swallows the interruption is
interrupted again each second; code in C is interrupted once it comes back to Python.
"""

from __future__ import annotations

import signal
import traceback
from contextlib import contextmanager, nullcontext
from threading import get_ident, main_thread
from types import FrameType, TracebackType
from typing import Any, ContextManager, Iterator, List, Optional, Set, Type

from rqt_mrta_py.errors import HookError, MrtaError

__all__ = ["DEFAULT_PATIENCE", "OutOfPatienceError", "Patience"]

DEFAULT_PATIENCE = 60.0
"""How long one answer may take [s]."""

_REPEAT = 1.0
_SHORTEST = 1e-3
_OWN = __name__.partition(".")[0]
_HAS_TIMER = hasattr(signal, "setitimer")


class OutOfPatienceError(HookError):
    """A plugin has not answered in time and was interrupted."""


class Patience:
    """Limits how long plugins may take.

    Args:
        seconds: that one answer may take; 0: no limit [s].
    """

    def __init__(self, seconds: float = DEFAULT_PATIENCE) -> None:
        self._seconds = max(seconds, _SHORTEST) if seconds > 0 and _HAS_TIMER else 0.0
        self._packages: Set[str] = set()
        self._unlimited = nullcontext()

    def know(self, module: str) -> None:
        """Take note that a module, and all that is in its topmost package, is a plugin's."""
        package = module.partition(".")[0]
        if package != _OWN:
            self._packages.add(package)

    def limit(self, who: str) -> ContextManager[Any]:
        """Give a context that interrupts what is done within once it has taken too long.

        Within another such context the outer one's time stands still. Off the main thread, and where somebody else
        has set the process's alarm, there is no limit.

        Args:
            who: is asked what, for instance ``plugin 'x': mrta_register_agents``; begins the message.

        Returns:
            A context; on leaving it raises OutOfPatienceError if it was interrupted, naming file, line and function
            of the innermost code of a plugin.
        """
        if not self._seconds or get_ident() != main_thread().ident:
            return self._unlimited
        return _Limit(who, self._seconds, self._packages)

    @contextmanager
    def at_work(self, who: str) -> Iterator[None]:
        """Give a context in which plugins work unnamed: limits them, and says whose code it is that raises.

        Args:
            who: is at work, for instance ``the mission's tick at 12.35 s``; begins the message.

        Raises:
            OutOfPatienceError: as ``limit``.
            HookError: a plugin's code raised what does not speak to the user yet; names file, line and function.
        """
        try:
            with self.limit(who):
                yield
        except (MrtaError, BrokenPipeError):
            raise
        except Exception as error:
            place = _place_of(error, self._packages)
            if place is None:
                raise
            raise HookError(f"{who}: {type(error).__name__}: {error}, {place}") from error


class _Interruption(BaseException):
    """Interrupts a plugin; not an Exception, for plugins catch those."""

    def __init__(self, limit: _Limit, place: str) -> None:
        super().__init__(place)
        self.limit = limit
        self.place = place


class _Limit:
    """One use of the alarm; ``packages`` tells plugins' code from ours."""

    __slots__ = ("_outer", "_seconds", "packages", "who")

    def __init__(self, who: str, seconds: float, packages: Set[str]) -> None:
        self.who = who
        self.packages = packages
        self._seconds = seconds
        self._outer = 0.0

    def __enter__(self) -> None:
        _alarm.install()
        self._outer = signal.setitimer(signal.ITIMER_REAL, self._seconds, _REPEAT)[0]
        if self._outer and not _alarm.limits:
            # Somebody else's alarm: theirs was there first.
            signal.setitimer(signal.ITIMER_REAL, self._outer)
        else:
            _alarm.limits.append(self)

    def __exit__(
        self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        if not _alarm.limits or _alarm.limits[-1] is not self:
            return
        _alarm.limits.pop()
        signal.setitimer(signal.ITIMER_REAL, self._outer, _REPEAT)
        if isinstance(error, _Interruption) and error.limit is self:
            raise OutOfPatienceError(
                f"{self.who}: no answer within {self._seconds:g} s; interrupted {error.place}; "
                "RQT_MRTA_PY_PATIENCE sets another limit [s], 0 for none"
            ) from error


class _Alarm:
    """The process's one alarm: whose limits it serves, innermost last, and who was served before us."""

    def __init__(self) -> None:
        self.limits: List[_Limit] = []
        self._installed = False
        self._before: Any = None

    def install(self) -> None:
        """Take the signal, once: doing so at each use would cost more than all the rest."""
        if not self._installed:
            self._before = signal.signal(signal.SIGALRM, self._ring)
            self._installed = True

    def _ring(self, number: int, frame: Optional[FrameType]) -> None:
        if not self.limits:
            if callable(self._before):
                self._before(number, frame)
            return
        if frame is None or frame.f_code.co_filename == _place.__code__.co_filename:
            return  # entering or leaving; it rings again
        limit = self.limits[-1]
        raise _Interruption(limit, _place(frame, limit.packages))


_alarm = _Alarm()


def _place(frame: FrameType, packages: Set[str]) -> str:
    """Describe the innermost frame that is a plugin's, else not ours, else any."""
    frames = [frame]
    while frames[-1].f_back is not None:
        frames.append(frames[-1].f_back)
    modules = [_package(each) for each in frames]
    plugins = (each for each, module in zip(frames, modules) if module in packages)
    foreign = (each for each, module in zip(frames, modules) if module != _OWN)
    found = next(plugins, None) or next(foreign, frame)
    return _told(found, found.f_lineno)


def _place_of(error: BaseException, packages: Set[str]) -> Optional[str]:
    """Describe the innermost code of a plugin that an exception came through; None if it came through none."""
    place = None
    for frame, line in traceback.walk_tb(error.__traceback__):
        if _package(frame) in packages:
            place = _told(frame, line)
    return place


def _package(frame: FrameType) -> str:
    return str(frame.f_globals.get("__name__", "")).partition(".")[0]


def _told(frame: FrameType, line: int) -> str:
    return f"in {frame.f_code.co_name} ({frame.f_code.co_filename}:{line})"
