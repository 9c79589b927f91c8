"""What a finished set-up was made from; equal means that nothing needs doing."""

from __future__ import annotations

import hashlib
import json
import os
import sys
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Iterable, List, Optional, Tuple

LEVELS = ("run", "test")

_NAME = ".venv/set-up.json"
_PROBES = ("/usr/bin/python3", "/usr/lib/python3/dist-packages/rospy", "/usr/lib/python3/dist-packages/genpy")
_MESSAGE_FOLDERS = ("msg", "srv", "plugins/messages/*/msg", "plugins/messages/*/srv")


@dataclass(frozen=True)
class Stamp:
    """All that a set-up depends on.

    Args:
        level: What it serves, ``run`` or ``test``; the second includes the first.
        checkout: Absolute path; virtual environments do not move.
        interpreter: Path and version of the Python beneath ``.venv``.
        ros: What is there of ROS.
        sources: Digest of the declared dependencies and of the bootstrap itself.
        messages: Digest of the message definitions.
        apt_owed: True where Debian packages are missing only because MRTA_NO_APT forbade apt.
    """

    level: str
    checkout: str
    interpreter: str
    ros: Tuple[str, ...]
    sources: str
    messages: str
    apt_owed: bool = False

    def serves(self, wanted: Stamp, apt_allowed: bool) -> bool:
        """Tell whether the set-up that left this stamp is what another one would make.

        Args:
            wanted: The stamp that the checkout calls for.
            apt_allowed: True where apt may now bring what it still owes.

        Returns:
            True when nothing needs doing.
        """
        same = replace(self, level=wanted.level, apt_owed=wanted.apt_owed) == wanted
        enough = LEVELS.index(self.level) >= LEVELS.index(wanted.level)
        return same and enough and not (self.apt_owed and apt_allowed)


def apt_allowed() -> bool:
    """Tell whether the user left MRTA_NO_APT unset, empty or 0.

    Returns:
        False for any other value.
    """
    return os.environ.get("MRTA_NO_APT", "0") in ("", "0")


def call_for(level: str, checkout: Path) -> Stamp:
    """Give the stamp that a checkout calls for as it is now.

    Args:
        level: ``run`` or ``test``.
        checkout: Its root folder.

    Returns:
        What a set-up would be made from.
    """
    sources = [checkout / "setup.py", *(checkout / "bootstrap").glob("*.py"), *(checkout / "bootstrap").glob("*.sh")]
    return Stamp(
        level=level,
        checkout=str(checkout),
        interpreter=f"{os.path.realpath(sys.executable)} {sys.version}",
        ros=ros_presence(),
        sources=_digest(checkout, sources),
        messages=_digest(checkout, message_files(checkout)),
    )


def ros_presence() -> Tuple[str, ...]:
    """List what there is of ROS, and of the Python that would carry it, without importing anything.

    Returns:
        Paths, sorted.
    """
    installed = [str(path) for path in Path("/opt/ros").glob("*/setup.bash")]
    return tuple(sorted(installed + [os.path.realpath(path) for path in _PROBES if Path(path).exists()]))


def message_files(checkout: Path) -> List[Path]:
    """List the message and service definitions of the main package and of those under plugins/messages.

    Args:
        checkout: Its root folder.

    Returns:
        Files, sorted.
    """
    found = (
        path for folder in _MESSAGE_FOLDERS for path in checkout.glob(f"{folder}/*") if path.suffix in (".msg", ".srv")
    )
    return sorted(found)


def read(checkout: Path) -> Optional[Stamp]:
    """Read the stamp of the last finished set-up.

    Args:
        checkout: Its root folder.

    Returns:
        None where there is none, or none that can be understood.
    """
    try:
        fields = json.loads((checkout / _NAME).read_text(encoding="utf-8"))
        return Stamp(**{**fields, "ros": tuple(fields["ros"])})
    except (OSError, ValueError, TypeError, KeyError):
        return None


def write(stamp: Stamp) -> None:
    """Leave a stamp, whole or not at all.

    Args:
        stamp: What the finished set-up was made from.
    """
    target = Path(stamp.checkout) / _NAME
    aside = target.with_suffix(".new")
    aside.write_text(json.dumps(asdict(stamp), indent=1, sort_keys=True) + "\n", encoding="utf-8")
    aside.replace(target)


def remove(checkout: Path) -> None:
    """Take the stamp away, so that a set-up which does not finish is taken up again.

    Args:
        checkout: Its root folder.
    """
    if (checkout / _NAME).exists():
        (checkout / _NAME).unlink()


def _digest(checkout: Path, files: Iterable[Path]) -> str:
    digest = hashlib.sha256()
    for path in sorted(files):
        content = path.read_bytes()
        digest.update(f"{path.relative_to(checkout)}\0{len(content)}\0".encode())
        digest.update(content)
    return digest.hexdigest()
