"""Turn message definitions into Python classes with ROS's genpy: ``python generate.py OUT FILE ...``.

Each FILE is ``<package>/msg/<Name>.msg`` or ``<package>/srv/<Name>.srv``. OUT gets ``<package>/msg`` and
``<package>/srv``, without ``<package>/__init__.py``: a package's own code, and a catkin workspace's classes of the
same name, go before these.
"""

from __future__ import annotations

import sys
from collections import defaultdict
from pathlib import Path
from typing import Dict, List, Tuple
from xml.etree import ElementTree

import genpy.generator
from genpy.generate_initpy import write_modules


def main(out: Path, files: List[Path]) -> int:
    """Generate all classes.

    Args:
        out: Folder to write to.
        files: Definitions.

    Returns:
        0, or the exit code of the first package that failed.
    """
    groups: Dict[Tuple[str, str], List[str]] = defaultdict(list)
    search: Dict[str, List[str]] = defaultdict(list)
    for path in files:
        package = _package_of(path)
        groups[package, path.parent.name].append(str(path))
        search[package] = [str(path.parents[1] / "msg")]
    for share in [*sorted(Path("/opt/ros").glob("*/share")), Path("/usr/share")]:
        for folder in sorted(share.glob("*/msg")):
            search[folder.parent.name].append(str(folder))
    for (package, kind), definitions in sorted(groups.items()):
        folder = out / package / kind
        folder.mkdir(parents=True)
        generator = genpy.generator.MsgGenerator() if kind == "msg" else genpy.generator.SrvGenerator()
        code = generator.generate_messages(package, definitions, str(folder), dict(search))
        if code:
            return int(code)
        write_modules(str(folder))
    return 0


def _package_of(definition: Path) -> str:
    name = ElementTree.parse(definition.parents[1] / "package.xml").findtext("name")
    return (name or definition.parents[1].name).strip()


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), [Path(name) for name in sys.argv[2:]]))
