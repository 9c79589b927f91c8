"""Import modules one after the other, in the environment's interpreter: ``python -I probe.py MODULE ...``.

Prints ``begin MODULE`` before and ``failed MODULE WHY`` after an import that went wrong, so that even a crash can be
laid at its module's door.
"""

from __future__ import annotations

import importlib
import sys
import warnings


def main() -> None:
    """Import what the command line names; a warning about versions that do not fit counts as a failure."""
    for category in (UserWarning, RuntimeWarning):
        warnings.filterwarnings("error", message=r"(?is).*(numpy|multiple versions)", category=category)
    for module in sys.argv[1:]:
        print(f"begin {module}", flush=True)
        try:
            importlib.import_module(module)
        except Exception as error:  # noqa: BLE001 - compiled modules raise anything when they do not fit
            print(f"failed {module} {type(error).__name__}: {' '.join(str(error).split())}", flush=True)


if __name__ == "__main__":
    main()
