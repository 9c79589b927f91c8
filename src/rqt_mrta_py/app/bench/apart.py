"""A measurement in a process of its own, so that it does not find what another left."""

from __future__ import annotations

import multiprocessing
from multiprocessing.connection import Connection
from typing import Any, Callable, Tuple, TypeVar, cast

from rqt_mrta_py.errors import MrtaError, UsageError

__all__ = ["apart"]

_Result = TypeVar("_Result")


def apart(function: Callable[..., _Result], *arguments: Any) -> _Result:
    """Call a function in a fresh process, and give what it gives.

    Args:
        function: what it gives can be pickled.
        arguments: of the function; they need not be.

    Raises:
        MrtaError: the function raised it, or the process ended without a word.
    """
    context = multiprocessing.get_context("fork")
    answers, answer = context.Pipe(duplex=False)
    process = context.Process(target=_answer, args=(answer, function, arguments))
    process.start()
    answer.close()
    try:
        error, result = answers.recv()
    except EOFError:
        error, result = UsageError("the process of the measurement ended without a word"), None
    process.join()
    if error is not None:
        raise error
    return cast(_Result, result)


def _answer(answer: Connection, function: Callable[..., Any], arguments: Tuple[Any, ...]) -> None:
    try:
        result = function(*arguments)
    except MrtaError as error:
        answer.send((error, None))
    else:
        answer.send((None, result))
