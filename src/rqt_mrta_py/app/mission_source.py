"""What a stream is about: what the user says of it, else what it says itself."""

from __future__ import annotations

import dataclasses
from typing import Optional, Tuple

from rqt_mrta_py.app.compose import Host
from rqt_mrta_py.app.mission_message import MISSION_TOPIC, MISSION_TYPE, mission_from_fields
from rqt_mrta_py.config.mission import load_mission, load_observed
from rqt_mrta_py.errors import TransportError
from rqt_mrta_py.hooks import Codec, Stamped
from rqt_mrta_py.model import Mission

__all__ = ["named_mission", "silent_about_itself", "told_mission"]


def named_mission(host: Host, application: Optional[str], architecture: Optional[str], name: str) -> Optional[Mission]:
    """Load what the user says that a stream is about.

    Args:
        host: knows what is registered.
        application: a registered name or path; None if the user names none.
        architecture: a registered name or path; None for the application's own.
        name: of the mission where only its architecture is named.

    Returns:
        The mission; None if the user names neither.

    Raises:
        MrtaError: of whatever is wrong with what is named.
    """
    if application is not None:
        return load_mission(
            host.registry,
            application,
            architecture=architecture,
            seed=None,
            checks=host.manager,
            must_fit=False,
        )
    if architecture is None:
        return None
    mission = load_observed(host.registry, architecture)
    return dataclasses.replace(mission, application=dataclasses.replace(mission.application, name=name))


def told_mission(stamped: Stamped, codec: Codec, where: str) -> Tuple[Mission, Optional[float]]:
    """Read the message by which a stream says what it is about.

    Args:
        stamped: of the topic for it.
        codec: reads it.
        where: names the stream.

    Returns:
        The mission, and how long it is planned to take [s]; None if unknown.

    Raises:
        TransportError: the message is of another type, or its bytes do not fit.
        ConfigError: a text in it is not acceptable.
    """
    if stamped.connection.type != MISSION_TYPE:
        raise TransportError(f"{where}: {MISSION_TOPIC} has type {stamped.connection.type}; {MISSION_TYPE} is expected")
    fields = codec.decode(stamped.connection, stamped.raw)
    return mission_from_fields(fields), float(fields["duration"]) or None


def silent_about_itself(where: str) -> str:
    """Say that a stream does not tell what it is about, and what to do."""
    return (
        f"{where}: does not say what it is about (no message on {MISSION_TOPIC}); "
        "give --application or --architecture, a registered name or an rqt_mrta.xml"
    )
