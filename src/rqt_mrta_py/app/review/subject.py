"""What a recording is about, who says so, and why that is believed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.mission_source import named_mission, silent_about_itself, told_mission
from rqt_mrta_py.app.review.inference import guess
from rqt_mrta_py.app.review.recordings import Recordings
from rqt_mrta_py.errors import UsageError
from rqt_mrta_py.hooks import Codec
from rqt_mrta_py.model import Mission

__all__ = ["Subject", "subject_of"]


@dataclass(frozen=True)
class Subject:
    """What a recording is about.

    Attributes:
        mission: as far as it is known.
        duration: planned [s]; None if unknown.
        source: ``named`` by the user, ``told`` by the bag, or ``inferred`` from its topics.
        why: it is believed, in a sentence; empty unless inferred.
    """

    mission: Mission
    duration: Optional[float]
    source: str
    why: str = ""


def subject_of(
    host: Host, recordings: Recordings, application: Optional[str], architecture: Optional[str], codec: Codec
) -> Subject:
    """Find out what a recording is about: what the user says, else what it says itself, else what its topics look like.

    Args:
        host: knows what is registered.
        recordings: the bags.
        application: a registered name or path; None if the user names none.
        architecture: likewise.
        codec: reads messages.

    Raises:
        UsageError: nobody says it, and no registered architecture fits.
        MrtaError: of whatever is wrong with what is named or told.
    """
    mission = named_mission(host, application, architecture, recordings.name)
    if mission is not None:
        return Subject(mission, None, "named")
    stamped = recordings.told()
    if stamped is not None:
        return Subject(*told_mission(stamped, codec, recordings.where), "told")
    found = guess(host, recordings.connections, codec)
    if found is None:
        raise UsageError(
            f"{silent_about_itself(recordings.where)}; no registered architecture fits its topics and types"
        )
    mission = named_mission(host, found.application, found.architecture, recordings.name)
    if mission is None:
        raise UsageError(silent_about_itself(recordings.where))
    what = f"application {found.application} under {found.architecture}" if found.application else found.architecture
    why = f"says nothing of itself; it is read as {what}, for {found.why}"
    if found.others:
        why += f"; {', '.join(found.others)} would fit as well, --architecture chooses"
    return Subject(mission, None, "inferred", f"{recordings.where}: {why}")
