from __future__ import annotations

import pytest
from basic_behaviours.drop_zone import DropZone

from rqt_mrta_py.model import Pose

ZONE = DropZone(Pose(1.0, 1.0), 1.0, 0.6)


def test_slots_are_the_centre_and_rings_of_six_more_each() -> None:
    # The ring at 0.6 m keeps 0.4 m from the edge, at least half of 0.6; one at 1.2 m would lie outside.
    centre, ring = ZONE.slots()
    assert centre == (Pose(1.0, 1.0),)
    assert [(round(slot.x, 3), round(slot.y, 3)) for slot in ring] == [
        (1.6, 1.0),
        (1.3, 1.52),
        (0.7, 1.52),
        (0.4, 1.0),
        (0.7, 0.48),
        (1.3, 0.48),
    ]
    assert [len(ring) for ring in DropZone(Pose(0.0, 0.0), 2.0, 0.6).slots()] == [1, 6, 12]


def test_the_centre_comes_first_then_the_slot_nearest_to_the_robot() -> None:
    robot = Pose(-3.0, 1.0)
    assert ZONE.free_slot((), robot) == Pose(1.0, 1.0)
    slot = ZONE.free_slot((Pose(1.0, 1.1),), robot)
    assert (slot.x, slot.y) == pytest.approx((0.4, 1.0))


def test_a_slot_with_something_near_it_is_taken() -> None:
    robot = Pose(-3.0, 1.0)
    # 0.8 * 0.6 = 0.48 m of room are asked of a new slot.
    assert ZONE.free_slot((Pose(1.47, 1.0),), robot) != Pose(1.0, 1.0)
    assert ZONE.free_slot((Pose(1.49, 1.0),), robot) == Pose(1.0, 1.0)
    # 0.6 * 0.6 = 0.36 m keep one.
    assert ZONE.is_free(Pose(1.0, 1.0), (Pose(1.37, 1.0),))
    assert not ZONE.is_free(Pose(1.0, 1.0), (Pose(1.35, 1.0),))


def test_a_full_zone_takes_things_where_there_is_most_room() -> None:
    ring = [slot for slots in ZONE.slots() for slot in slots]
    taken = [*ring[:3], Pose(ring[3].x, ring[3].y + 0.4), *ring[4:]]
    assert ZONE.free_slot(taken, Pose(1.0, -3.0)) == ring[3]


def test_the_zone_ends_at_its_radius() -> None:
    assert ZONE.contains(Pose(2.0, 1.0))
    assert not ZONE.contains(Pose(2.1, 1.0))
    assert ZONE.contains(Pose(2.1, 1.0), slack=0.15)
