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
    return {"id": name, "kind": kind, "position": {"x": x, "y": y, "z": 0.05}, "held": held}


def heard(*detections: Dict[str, Any], frame: str = "map") -> Heard:
    fields = {"header/frame_id": frame, "detections": list(detections)}
    return Heard("/simulation/bodies", "rqt_mrta_py/Detections", 1.0, fields)


def keeper() -> BodyKeeper:
    return BodyKeeper(ScenarioSpec(Arena(-3.0, -3.0, 3.0, 3.0), (), (), bodies=(CAN,), dispensers=(PLACE,)))


def test_bodies_are_shown_where_they_were_told_last() -> None:
    kept = keeper()
    assert kept.bodies() == ()
    kept.hear(heard(told("tin", 1.0, 2.0, "metal"), told("can", 3.0, 4.0, held=True)))
    kept.hear(heard(told("tin", 1.5, 2.0, "metal"), told("can", 3.0, 4.5, held=True)))
    assert kept.bodies() == (
        BodySight("can", "paper", 3.0, 4.5, 0.2, held=True),  # as large as 0.4 m by 0.1 m
        BodySight("tin", "metal", 1.5, 2.0, 0.1),
    )


def test_bodies_of_a_dispenser_are_shown_in_their_size() -> None:
    kept = keeper()
    kept.hear(heard(told("place_2", 1.0, 2.0), told("place_3", 2.0, 2.0)))
    assert [(body.id, pytest.approx(body.width)) for body in kept.bodies()] == [("place_2", 0.3), ("place_3", 0.1)]
    assert [(track.id, pytest.approx(track.width)) for track in kept.tracks()] == [("place_2", 0.3), ("place_3", 0.1)]


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
    bodies = [BodySight(f"b{i}", kind, x, y, 0.3) for i, ((x, y), kind) in enumerate(zip(spots, kinds))]
    first, second = [list(colour) for colour in BODY_COLOURS[:2]]
    assert colours_at(bodies) == [second, first, second]


def test_body_that_a_robot_holds_is_drawn_upon_the_robot() -> None:
    robot = views.patrol().scene.robots[0]
    assert robot.pose is not None
    body = BodySight("can", "paper", robot.pose.x, robot.pose.y, 0.2)
    assert colours_at([body]) != [list(BODY_COLOURS[0])]
    assert colours_at([replace(body, held=True)]) == [list(BODY_COLOURS[0])]


def test_small_body_is_drawn_large_enough_to_be_seen() -> None:
    place = ArenaMap(Arena(-50.0, -50.0, 50.0, 50.0), inside(ARENA))
    ((box,), ()) = place_bodies([BodySight("can", "paper", 0.0, 0.0, 0.1)], place)
    assert 2.0 * box.half == 7.0


def test_body_too_far_away_for_arithmetic_is_left_out() -> None:
    place = ArenaMap(Arena(-5.0, -5.0, 5.0, 5.0), inside(ARENA))
    assert place_bodies([BodySight("can", "paper", 1e300, 0.0, 0.1)], place) == ([], [])


def test_bodies_are_somewhere_even_where_no_arena_is_known() -> None:
    scene = SceneView(None, (), (), (), bodies=(BodySight("can", "paper", 7.0, 0.0, 0.1),))
    assert not without_places(scene)
    assert extent(scene).max_x > 7.0


def test_equal_bodies_give_equal_pictures_and_moved_ones_do_not() -> None:
    view = views.patrol()
    bodies = (BodySight("can", "paper", -4.5, 3.5, 0.1),)
    pictures = [
        draw_monitor(replace(view, scene=replace(view.scene, bodies=shown)))
        for shown in (bodies, bodies, (replace(bodies[0], x=-4.0),), ())
    ]
    assert np.array_equal(pictures[0], pictures[1])
    assert not np.array_equal(pictures[0], pictures[2])
    assert np.array_equal(pictures[3], draw_monitor(view))
