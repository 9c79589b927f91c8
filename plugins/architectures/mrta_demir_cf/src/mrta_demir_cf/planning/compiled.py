"""The door to numba, which compiles loops over arrays: the extra ``compiled``. Everything works without it, slowly.

Kernels are compiled when they are first called, once in every process (``cache=True`` is not safe here: numba looks at
the file of a kernel only, not at those of the kernels that it calls, and would go on with old ones).
"""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any, Callable, TypeVar, cast

__all__ = ["has_compiler", "inner_kernel", "kernel"]

_Function = TypeVar("_Function", bound=Callable[..., Any])


def has_compiler() -> bool:
    """Tell whether kernels are compiled."""
    return find_spec("numba") is not None


def kernel(function: _Function) -> _Function:
    """Compile a function of numbers and arrays, or leave it as it is where numba is not installed.

    Floating-point operations are neither reordered nor contracted: results are those of the plain function to the last
    bit. Modules with kernels import numba when they are imported, so they are to be imported when needed.
    """
    return _compiled(function)


def inner_kernel(function: _Function) -> _Function:
    """Compile a function as ``kernel`` does, for other kernels only: that takes half as long.

    Where numba is installed, Python cannot call it, but for its ``py_func``.
    """
    return _compiled(function, no_cpython_wrapper=True, no_cfunc_wrapper=True)


def _compiled(function: _Function, **options: Any) -> _Function:
    if not has_compiler():
        return function
    import numba

    # Without checks for divisions by zero, of which there are none, compilation is shorter.
    njit: Callable[..., Any] = numba.njit
    return cast(_Function, njit(error_model="numpy", **options)(function))
