from __future__ import annotations

import math
from typing import Tuple

import pytest
from basic_behaviours.drop_zone import DropZone
from basic_behaviours.findings import Findings, fresh_detections, on_map

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import Pose
from tests.plugins.basic_behaviours.perception import Perceived

HERE = Pose(1.0, 2.0, math.pi / 2)


def findings() -> Findings:
    return Findings("can", DropZone(Pose(9.0, 2.0), 1.0, 0.6))


def seen(*things: Tuple[str, str, float, float], held: Tuple[str, ...] = (), now: float = 1.0) -> Heard:
    """Give what a detector says: id, kind, x ahead and y to the left of each."""
    fields = [
        {"id": name, "kind": kind, "position": {"x": x, "y": y, "z": 0.05}, "held": name in held}
        for name, kind, x, y in things
    ]
    return Heard("/robot1/detections", "rqt_mrta_py/Detections", now, {"detections": fields})


def test_places_are_brought_to_the_map() -> None:
    # Heading along y: 2 m ahead is 2 m up, 0.5 m to the left is 0.5 m back along x.
    place = on_map(HERE, 2.0, 0.5)
    assert (place.x, place.y) == pytest.approx((0.5, 4.0))


def test_things_of_the_kind_are_remembered_sorted() -> None:
    known = findings()
    assert known.see(seen(("can2", "can", 1.0, 0.0), ("box", "crate", 1.0, 1.0), ("can1", "can", 2.0, 0.0)), HERE, 1.0)
    assert [thing.id for thing in known.things] == ["can1", "can2"]
    place = known.things[0].place
    assert (place.x, place.y) == pytest.approx((1.0, 4.0))


def test_nothing_is_new_about_what_is_known_or_about_the_same_message() -> None:
    known, message = findings(), seen(("can1", "can", 1.0, 0.0))
    assert known.see(message, HERE, 1.0)
    assert not known.see(message, HERE, 1.1)
    assert not known.see(seen(("can1", "can", 1.0, 0.1)), HERE, 1.2)


def test_what_lies_in_the_drop_zone_is_taken_and_not_left() -> None:
    known = findings()
    there = Pose(8.0, 2.0)
    assert not known.see(seen(("can1", "can", 1.2, 0.0), ("box", "crate", 0.5, 0.0)), there, 1.0)
    assert known.things == ()
    assert [(place.x, place.y) for place in known.taken] == [(8.5, 2.0), (9.2, 2.0)]


def test_a_thing_on_the_edge_of_the_zone_stays_in_it_whatever_the_noise() -> None:
    known, there = findings(), Pose(7.0, 2.0)
    known.see(seen(("can1", "can", 1.02, 0.0)), there, 1.0)
    # Now 1.1 m from the centre: outside for what was outside, inside for what was inside.
    assert not known.see(seen(("can1", "can", 0.9, 0.0)), there, 1.2)
    assert known.things == ()
    assert known.see(seen(("can2", "can", 0.9, 0.0)), there, 1.4)
    assert [thing.id for thing in known.things] == ["can2"]


def test_what_others_hold_is_not_left() -> None:
    known = findings()
    known.see(seen(("can1", "can", 1.0, 0.0)), HERE, 1.0)
    assert not known.see(seen(("can1", "can", 1.0, 0.0), held=("can1",)), HERE, 1.2)
    assert known.things == ()


def test_a_thing_that_is_near_ahead_and_not_seen_for_a_second_is_gone() -> None:
    known = findings()
    known.see(seen(("can1", "can", 1.0, 0.0)), HERE, 1.0)
    assert not known.see(seen(), HERE, 1.9)
    assert known.see(seen(), HERE, 2.1), "that is a surprise"
    assert known.things == ()


@pytest.mark.parametrize("pose", [Pose(1.0, 2.0, -math.pi / 2), Pose(1.0, 0.5, math.pi / 2)])
def test_a_thing_that_is_behind_or_far_need_not_be_seen(pose: Pose) -> None:
    known = findings()
    known.see(seen(("can1", "can", 1.0, 0.0)), HERE, 1.0)
    assert not known.see(seen(), pose, 60.0)
    assert [thing.id for thing in known.things] == ["can1"]


def test_detections_are_fresh_for_a_second() -> None:
    perceived = Perceived(HERE)
    assert fresh_detections(perceived) is None
    perceived.hear("detections", "rqt_mrta_py/Detections", {"detections": []})
    perceived.now += 1.0
    assert fresh_detections(perceived) is not None
    perceived.now += 0.1
    assert fresh_detections(perceived) is None
