"""Entry of ``python3 -I bootstrap LEVEL WHAT``."""

from __future__ import annotations

import sys
from pathlib import Path

# Python put this folder first on the path; its modules are known as bootstrap.*.
sys.path[0] = str(Path(__file__).resolve().parent.parent)

from bootstrap.sequence import main  # noqa: E402

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
