"""The door to numba, which compiles the loop of training: the extra ``compiled``. Without it all goes slowly."""

from __future__ import annotations

from functools import lru_cache
from importlib.util import find_spec
from typing import Callable

from block_construction.learning import credit, drawing, fala, memory, pla, reward, stops, training

__all__ = ["has_compiler", "is_compiled", "training_loop"]

_INNER = (
    *(credit.is_fault, credit.local_cost, drawing.is_open, drawing.draw_action, drawing.draw_diagram),
    *(fala.chosen_probability, fala.other_probability, memory.remember),
    *(pla.boltzmann, pla.log_gradient, pla.parameter_change, pla.restoring_force, reward.reward),
    *(stops.greatest, stops.hits_among_recent, training.learn_parameters, training.learn_probabilities),
)
"""What the loop calls."""


def has_compiler() -> bool:
    """Tell whether numba is installed."""
    return find_spec("numba") is not None


def is_compiled() -> bool:
    """Tell whether this process has made the compiled loop already."""
    return _compiled.cache_info().currsize > 0


def training_loop(compiled: bool) -> Callable[..., bool]:
    """Give the loop of training, compiled when it is first called, or as it is written.

    Floating-point operations are neither reordered nor contracted, and chance comes from the same NumPy generator: both
    forms come to the same numbers, to the last bit. The compiled form lets other threads run meanwhile.

    Args:
        compiled: whether to compile it, for which numba must be installed.
    """
    return _compiled() if compiled else training.train


@lru_cache(maxsize=None)
def _compiled() -> Callable[..., bool]:
    import numba
    from numba.extending import register_jitable

    for function in _INNER:
        register_jitable(function)
    # Without checks for divisions by zero, of which there are none, compilation is shorter.
    loop: Callable[..., bool] = numba.njit(training.train, nogil=True, error_model="numpy")
    return loop
