"""A trace of hook calls, for authors of plugins: who was asked what, when, how long it took, what came back."""

from __future__ import annotations

from logging import Logger
from typing import Any, Callable, Mapping, TypeVar

from rqt_mrta_py.wording import shown

__all__ = ["HookTrace"]

_Answer = TypeVar("_Answer")

_MOST = 8


class HookTrace:
    """Writes a line for each call of a hook.

    Args:
        logger: takes the lines, at level INFO.
        clock: gives the time [s]; the trace begins now.
    """

    def __init__(self, logger: Logger, clock: Callable[[], float]) -> None:
        self._logger = logger
        self._clock = clock
        self._start = clock()

    def call(self, plugin: str, hook: str, function: Callable[..., _Answer], *arguments: Any) -> _Answer:
        """Call a plugin's function and write down the call.

        Args:
            plugin: whose function it is.
            hook: that it implements.
            function: to be called.
            arguments: to call it with.

        Returns:
            What the function returned; what it raises passes, noted.
        """
        begun = self._clock()
        came = "interrupted"
        try:
            answer = function(*arguments)
            came = f"returned={_short(answer)}"
            return answer
        except Exception as error:
            came = f"raised={type(error).__name__}"
            raise
        finally:
            took = self._clock() - begun
            at = begun - self._start
            self._logger.info("at_ms=%.3f plugin=%s hook=%s took_ms=%.3f %s", 1e3 * at, plugin, hook, 1e3 * took, came)


def _short(answer: object) -> str:
    """Name what a mapping holds, count what a sequence holds, quote anything else."""
    if isinstance(answer, Mapping):
        names = [str(name) for name in answer]
        more = f",and {len(names) - _MOST} more" if len(names) > _MOST else ""
        return f"{{{','.join(names[:_MOST])}{more}}}"
    if isinstance(answer, (list, tuple)):
        return f"{len(answer)} of {type(answer).__name__}"
    return shown(answer)
