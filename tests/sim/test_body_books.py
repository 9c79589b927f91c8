"""Whatever the order of calls, a world knows which bodies there are and who holds them."""

from __future__ import annotations

from typing import Dict, Optional

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rqt_mrta_py.errors import SimError
from rqt_mrta_py.hooks import Body
from rqt_mrta_py.model import Pose
from tests.sim.worlds import WORLDS, setup

NAMES = ("a", "b")
HEIGHTS = {"a": 0.1, "b": 0.6}
CALLS = st.tuples(st.sampled_from(["add", "remove", "attach", "detach", "step"]), st.sampled_from(NAMES))


@settings(max_examples=25, deadline=None)
@given(st.sampled_from(sorted(WORLDS)), st.lists(st.tuples(CALLS, st.sampled_from(["r0", "r1"])), max_size=12))
def test_world_keeps_its_books_of_bodies_in_any_order_of_calls(world_name, calls):
    world = WORLDS[world_name]()
    holder: Dict[str, Optional[str]] = {}
    try:
        world.reset(setup(Pose(-1.0, 0.0), Pose(1.0, 0.0)))
        for (verb, name), robot in calls:
            body = Body(name, (0.0, 0.0, HEIGHTS[name]), 0.0, (0.2, 0.2, 0.2), 0.1)
            call, is_allowed = {
                "add": (lambda body=body: world.add_body(body), name not in holder),
                "remove": (lambda name=name: world.remove_body(name), name in holder),
                "attach": (
                    lambda robot=robot, name=name: world.attach(robot, name),
                    name in holder and holder[name] is None,
                ),
                "detach": (lambda name=name: world.detach(name), holder.get(name) is not None),
                "step": (world.step, True),
            }[verb]
            if not is_allowed:
                with pytest.raises(SimError, match=f"body {name}: "):
                    call()
                continue
            call()
            if verb == "remove":
                del holder[name]
            elif verb != "step":
                holder[name] = robot if verb == "attach" else None
            assert list(world.bodies()) == list(holder)
        world.step()
        assert world.poses().shape == (2, 3)
    finally:
        world.close()
