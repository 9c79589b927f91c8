"""One client of PyBullet: loaded late and silently, set up alike after every reset."""

from __future__ import annotations

import ctypes
import os
import sys
from contextlib import contextmanager
from typing import Any, Iterator

from rqt_mrta_py.errors import MissingDependencyError, SimError

__all__ = ["Engine", "load_pybullet"]

_GRAVITY = 9.81
_SOLVER_ITERATIONS = 25
"""With 10, wheel speeds are off by some 2 mm/s, which a robot that waits would creep."""
_CONTACT_BREAKING_THRESHOLD = 0.001


def load_pybullet() -> Any:
    """Import PyBullet without letting it announce itself on stdout or stderr.

    Returns:
        The module ``pybullet``.

    Raises:
        MissingDependencyError: it is not installed or does not load.
    """
    if "pybullet" in sys.modules:
        return sys.modules["pybullet"]
    try:
        with _silence():
            import pybullet
    except ImportError as error:
        raise MissingDependencyError(
            f"world bullet: PyBullet cannot be imported ({error}); install it with: pip install 'rqt_mrta_py[sim]'"
        ) from error
    return pybullet


class Engine:
    """One physics client in this process, without a window.

    Attributes:
        bullet: the module ``pybullet``.
        client: number of the client; goes with every call as ``physicsClientId``.
    """

    def __init__(self) -> None:
        self.bullet: Any = load_pybullet()
        self.client: int = self.bullet.connect(self.bullet.DIRECT)
        if self.client < 0:
            raise SimError("world bullet: PyBullet gives no further physics client; close worlds that are not used")

    def reset(self, step: float) -> None:
        """Remove everything and set the engine up again, for a reset resets its parameters too.

        Args:
            step: length of one physics step [s].
        """
        self.bullet.resetSimulation(physicsClientId=self.client)
        self.bullet.setPhysicsEngineParameter(
            fixedTimeStep=step,
            numSolverIterations=_SOLVER_ITERATIONS,
            contactBreakingThreshold=_CONTACT_BREAKING_THRESHOLD,
            # Two friction forces, each on its own, take a tenth less time, and wheels hold as well.
            enableConeFriction=0,
            # Things collide if each accepts the other's group; PyBullet's own rule is: if either does.
            collisionFilterMode=0,
            # Without it, runs that begin in equal states drift apart.
            deterministicOverlappingPairs=1,
            physicsClientId=self.client,
        )
        self.bullet.setGravity(0.0, 0.0, -_GRAVITY, physicsClientId=self.client)

    def set_step(self, step: float) -> None:
        """Set the length of physics steps from now on [s]."""
        self.bullet.setPhysicsEngineParameter(fixedTimeStep=step, physicsClientId=self.client)

    def close(self) -> None:
        """Disconnect and free the client's memory; safe to call twice."""
        client, self.client = self.client, -1
        if client >= 0 and self.bullet.isConnected(physicsClientId=client):
            self.bullet.disconnect(physicsClientId=client)


@contextmanager
def _silence() -> Iterator[None]:
    """Send file descriptors 1 and 2 to nowhere; C code does not ask ``sys.stdout``."""
    sys.stdout.flush()
    sys.stderr.flush()
    kept = (os.dup(1), os.dup(2))
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, 1)
        os.dup2(nowhere, 2)
        yield
    finally:
        # What C has buffered must leave before the descriptors are back.
        ctypes.CDLL(None).fflush(None)
        for descriptor, copy in zip((1, 2), kept):
            os.dup2(copy, descriptor)
            os.close(copy)
        os.close(nowhere)
