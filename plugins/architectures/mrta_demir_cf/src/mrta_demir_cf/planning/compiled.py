"""The door to numba, which compiles loops over arrays: the extra ``compiled``. Everything works without it, slowly.

Kernels are compiled when they are first called, once in every process (``cache=True`` is not safe here: numba looks at
the file of a kernel only, not at those of the kernels that it calls, and would go on with old ones).
"""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any, Callable, TypeVar, cast

__all__ = ["has_compiler", "kernel"]

_Function = TypeVar("_Function", bound=Callable[..., Any])


def has_compiler() -> bool:
    """Tell whether kernels are compiled."""
    return find_spec("numba") is not None


def kernel(function: _Function) -> _Function:
    """Compile a function of numbers and arrays, or leave it as it is where numba is not installed.

    Floating-point operations are neither reordered nor contracted: results are those of the plain function to the last
    bit. Modules with kernels import numba when they are imported, so they are to be imported when needed.
    """
    if not has_compiler():
        return function
    from numba import njit

    return cast(_Function, njit(function))
