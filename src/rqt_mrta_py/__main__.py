"""``python -m rqt_mrta_py`` is ``mrta``."""

from __future__ import annotations

import sys

from rqt_mrta_py.app.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
