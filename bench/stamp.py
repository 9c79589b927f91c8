"""What ``./run`` spends before it starts Python in a checkout that is set up: looking at the stamp, beside a bare bash.

Both are started turn by turn in the same run, and the best of several turns counts. From a checkout:
``python -m bench.stamp``.
"""

from __future__ import annotations

import argparse
import subprocess
import time
from pathlib import Path
from typing import List, NamedTuple, Optional, Sequence

__all__ = ["StampRow", "main", "measure_stamp"]

_TURNS = 20


class StampRow(NamedTuple):
    """One comparison.

    Attributes:
        stamp: from the start of bash until the stamp is found to be valid [s].
        bash: the start and end of a bash that does nothing [s].
    """

    stamp: float
    bash: float

    @property
    def ratio(self) -> float:
        """Tell how many times as long as a bare bash it takes."""
        return self.stamp / self.bash


def measure_stamp(checkout: Path, turns: int = _TURNS) -> StampRow:
    """Measure a checkout whose stamp is valid.

    Args:
        checkout: its root folder.
        turns: of which the best counts.

    Raises:
        RuntimeError: the checkout is not set up, so that there is nothing to measure.
    """
    head = 'set -euo pipefail; checkout=$1; source "$checkout/bootstrap/bootstrap.sh"; '
    todo = _run(f"{head}what_to_do run", checkout)
    if todo != "nothing":
        raise RuntimeError(f"{checkout}: is not set up; call ./run list first")
    ways = (f"{head}bootstrap run", ":")
    best: List[float] = [float("inf")] * len(ways)
    for _ in range(turns):
        for place, script in enumerate(ways):
            start = time.perf_counter()
            _run(script, checkout)
            best[place] = min(best[place], time.perf_counter() - start)
    return StampRow(*best)


def _run(script: str, checkout: Path) -> str:
    command = ["bash", "-c", script, "bash", str(checkout)]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.strip()


def main(argv: Optional[Sequence[str]] = None) -> None:
    """Measure this checkout, and print a line.

    Args:
        argv: arguments without the program's name; None for the process's own.
    """
    parser = argparse.ArgumentParser(prog="python -m bench.stamp", description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--turns", metavar="N", type=int, default=_TURNS, help=f"the best counts (default: {_TURNS})")
    options = parser.parse_args(argv)
    if options.turns < 1:
        parser.error("--turns must be at least 1")
    row = measure_stamp(Path(__file__).resolve().parent.parent, options.turns)
    print(f"stamp {row.stamp:.3f} s, bash {row.bash:.3f} s: {row.ratio:.1f} times as long")


if __name__ == "__main__":
    main()
