"""Allocators for the multiple travelling robot problem, to compare architectures with.

* ``routes``: who visits what in which order, and how long that is
* ``prim``: Prim allocation; ``insertion``: sequential single-item auctions
* ``assignment``: round by round, and by nearness
* ``references``: the proved optimum, and solvers of vehicle routing problems
* ``experiments``: what ``mrta bench mtrp`` measures
* ``allocators``: the same as allocators of the hook; ``plugin``: the hooks
"""

from __future__ import annotations
