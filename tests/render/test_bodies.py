"""Loose bodies in pictures."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, Dict, List

import numpy as np
import pytest

from rqt_mrta_py.hooks import BodySight, Heard, SceneView
from rqt_mrta_py.model import Arena, Dispenser, LooseBody, Pose, ScenarioSpec
from rqt_mrta_py.render import draw_monitor
from rqt_mrta_py.render.bodies import place_bodies
from rqt_mrta_py.render.body_keeper import BodyKeeper
from rqt_mrta_py.render.floor import ArenaMap, extent, without_places
from rqt_mrta_py.render.layout import ARENA, inside
from rqt_mrta_py.render.palette import BODY_COLOURS
from rqt_mrta_py.render.scene import SceneTracker
from tests.render import views
from tests.render.test_scene import mission

CAN = LooseBody("can", Pose(0.0, 0.0), (0.4, 0.1, 0.2))
PLACE = Dispenser("place", Pose(2.0, 0.0), (0.9, 0.1, 0.2), stock=2)


def told(name: str, x: float, y: float, kind: str = "paper", held: bool = False) -> Dict[str, Any]:
    return {"id": name, "kind": kind, "position": {"x": x, "y": y, "z": 0.1}, "held": held, "yaw": 0.5}


def heard(*detections: Dict[str, Any], frame: str = "map", receipt: float = 1.0) -> Heard:
    fields = {"header/frame_id": frame, "detections": list(detections)}
    return Heard("/simulation/bodies", "rqt_mrta_py/Detections", receipt, fields)


def keeper() -> BodyKeeper:
    return BodyKeeper(ScenarioSpec(Arena(-3.0, -3.0, 3.0, 3.0), (), (), bodies=(CAN,), dispensers=(PLACE,)))


def test_bodies_are_shown_where_they_were_told_last() -> None:
    kept = keeper()
    assert kept.bodies() == ()
    kept.hear(heard(told("tin", 1.0, 2.0, "metal"), told("can", 3.0, 4.0, held=True)))
    kept.hear(heard(told("tin", 1.5, 2.0, "metal"), told("can", 3.0, 4.5, held=True)))
    assert kept.bodies() == (
        BodySight("can", "paper", 3.0, 4.5, 0.4, 0.1, yaw=0.5, held=True),
        BodySight("tin", "metal", 1.5, 2.0, 0.1, 0.1, yaw=0.5, lift=0.1),
    )


def test_bodies_of_a_dispenser_are_shown_in_their_size() -> None:
    kept = keeper()
    kept.hear(heard(told("place_2", 1.0, 2.0), told("place_3", 2.0, 2.0)))
    sizes = [("place_2", 0.9, 0.1), ("place_3", 0.1, 0.1)]
    assert [(body.id, body.length, body.width) for body in kept.bodies()] == sizes
    assert [(track.id, track.length, track.width) for track in kept.tracks()] == sizes


def test_a_recording_of_before_bodies_told_how_they_are_turned_shows_them_unturned() -> None:
    kept, old = keeper(), told("can", 1.0, 2.0)
    del old["yaw"]
    kept.hear(heard(old))
    assert kept.bodies() == (BodySight("can", "paper", 1.0, 2.0, 0.4, 0.1),)


def test_only_what_was_moved_turned_lifted_or_taken_is_kept_of_where_a_body_was() -> None:
    kept, lying = keeper(), told("can", 1.0, 2.0)
    lifted = {**lying, "position": {"x": 1.0, "y": 2.0, "z": 0.17}}
    turned = {**lifted, "yaw": 0.7}
    for each in (lying, lying, lifted, {**lifted, "yaw": 0.55}, turned, {**turned, "held": True}):
        kept.hear(heard(each))
    (track,) = kept.tracks()
    assert [(round(place.lift, 3), place.yaw, place.held) for place in track.places] == [
        (0.0, 0.5, False),
        (0.07, 0.5, False),
        (0.07, 0.7, False),
        (0.07, 0.7, True),
    ]


def test_a_body_that_is_told_of_no_more_is_gone_from_then_on_until_it_is_told_of_again() -> None:
    kept, tin, can = keeper(), told("tin", 1.0, 2.0), told("can", 3.0, 4.0, held=True)
    for receipt, there in ((1.0, (tin, can)), (2.0, (tin,)), (3.0, (tin,)), (4.0, (tin, can))):
        kept.hear(heard(*there, receipt=receipt))
        assert [body.id for body in kept.bodies()] == sorted(each["id"] for each in there)
    track, other = kept.tracks()
    assert [(place.time, place.x, place.held, place.is_there) for place in track.places] == [
        (1.0, 3.0, True, True),
        (2.0, 3.0, False, False),
        (4.0, 3.0, True, True),
    ]
    assert [(place.time, place.is_there) for place in other.places] == [(1.0, True)]


@pytest.mark.parametrize("wrong", [heard(told("can", 1.0, math.nan)), heard(told("can", 1.0, 1.0), frame="odom")])
def test_bodies_nowhere_or_in_another_frame_are_not_shown(wrong: Heard) -> None:
    kept = keeper()
    kept.hear(wrong)
    assert kept.bodies() == ()


def test_scene_hears_of_bodies() -> None:
    scene = SceneTracker(mission(), {})
    assert "/simulation/bodies" in [subscription.topic for subscription in scene.subscriptions()]
    scene.hear(heard(told("can", 1.0, 1.0)))
    assert [body.id for body in scene.view(2.0).bodies] == ["can"]


def colours_at(bodies: List[BodySight]) -> List[List[int]]:
    """Give red, green and blue at the middle of each body in a monitor picture."""
    view = views.patrol()
    view = replace(view, scene=replace(view.scene, bodies=tuple(bodies)))
    place, picture = ArenaMap(extent(view.scene), inside(ARENA)), draw_monitor(view)
    return [picture[round(y), round(x)][::-1].tolist() for x, y in (place(body.x, body.y) for body in bodies)]


def test_each_kind_of_bodies_has_its_colour_by_the_order_of_names() -> None:
    spots = [(-4.5, 3.5), (-4.5, 2.5), (4.5, -3.5)]
    kinds = ["paper", "metal", "paper"]
    bodies = [BodySight(f"b{i}", kind, x, y, 0.3, 0.3) for i, ((x, y), kind) in enumerate(zip(spots, kinds))]
    first, second = [list(colour) for colour in BODY_COLOURS[:2]]
    assert colours_at(bodies) == [second, first, second]


def test_body_that_a_robot_holds_is_drawn_upon_the_robot() -> None:
    robot = views.patrol().scene.robots[0]
    assert robot.pose is not None
    body = BodySight("can", "paper", robot.pose.x, robot.pose.y, 0.2, 0.2)
    assert colours_at([body]) != [list(BODY_COLOURS[0])]
    assert colours_at([replace(body, held=True)]) == [list(BODY_COLOURS[0])]


def test_small_body_is_drawn_large_enough_to_be_seen() -> None:
    place = ArenaMap(Arena(-50.0, -50.0, 50.0, 50.0), inside(ARENA))
    ((box,), ()) = place_bodies([BodySight("can", "paper", 0.0, 0.0, 0.1, 0.1)], place)
    (left, top), (right, bottom) = box.corners[3], box.corners[1]
    assert (right - left, bottom - top) == (7.0, 7.0)


def test_a_body_is_drawn_as_long_wide_and_turned_as_it_is() -> None:
    place = ArenaMap(Arena(-1.0, -1.0, 1.0, 1.0), inside(ARENA))
    ((box,), ()) = place_bodies([BodySight("can", "paper", 0.0, 0.0, 0.8, 0.2, yaw=math.pi / 6.0)], place)
    middle = place.inside(Pose(0.0, 0.0))
    found = [((x - middle[0]) / place.scale, (middle[1] - y) / place.scale) for x, y in box.corners]
    cos, sin = math.sqrt(3.0) / 2.0, 0.5
    by_hand = [(0.4 * cos - 0.1 * sin, 0.4 * sin + 0.1 * cos), (-0.4 * cos - 0.1 * sin, -0.4 * sin + 0.1 * cos)]
    expected = [*by_hand, *((-x, -y) for x, y in by_hand)]
    assert sorted(found) == [pytest.approx(corner) for corner in sorted(expected)]


def test_what_lies_higher_is_drawn_upon_what_is_below_it_and_paler() -> None:
    low = BodySight("b", "paper", -4.5, 3.5, 0.4, 0.4)
    high = BodySight("a", "paper", -4.5, 3.5, 0.4, 0.4, lift=0.15)
    (below,), (above,) = colours_at([low]), colours_at([high])
    # Half as high as what is palest, which is 70 % white.
    assert above == [round(part + 0.35 * (255 - part)) for part in below]
    assert colours_at([high, low]) == [above, above]


def test_body_too_far_away_for_arithmetic_is_left_out() -> None:
    place = ArenaMap(Arena(-5.0, -5.0, 5.0, 5.0), inside(ARENA))
    assert place_bodies([BodySight("can", "paper", 1e300, 0.0, 0.1, 0.1)], place) == ([], [])


def test_bodies_are_somewhere_even_where_no_arena_is_known() -> None:
    scene = SceneView(None, (), (), (), bodies=(BodySight("can", "paper", 7.0, 0.0, 0.1, 0.1),))
    assert not without_places(scene)
    assert extent(scene).max_x > 7.0


def test_equal_bodies_give_equal_pictures_and_moved_ones_do_not() -> None:
    view = views.patrol()
    bodies = (BodySight("can", "paper", -4.5, 3.5, 0.1, 0.1),)
    pictures = [
        draw_monitor(replace(view, scene=replace(view.scene, bodies=shown)))
        for shown in (bodies, bodies, (replace(bodies[0], x=-4.0),), ())
    ]
    assert np.array_equal(pictures[0], pictures[1])
    assert not np.array_equal(pictures[0], pictures[2])
    assert np.array_equal(pictures[3], draw_monitor(view))
