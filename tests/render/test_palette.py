from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from numpy.typing import NDArray

from rqt_mrta_py.model import RobotState
from rqt_mrta_py.render.palette import INK, STATE_COLOURS, TASK_COLOURS, WHITE, Colour, TaskColours, mix, readable_on
from tests.render import views

# Machado, Oliveira, Fernandes 2009, table 1, severity 1.0: linear RGB as seen without one kind of cone.
SIMULATIONS = {
    "protanopia": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "deuteranopia": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    "tritanopia": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
}


def lab(colour: Colour, kind: str) -> NDArray[np.float64]:
    srgb = np.array(colour) / 255.0
    linear = np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
    seen = np.clip(np.array(SIMULATIONS[kind]) @ linear, 0.0, 1.0) if kind else linear
    to_xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    xyz = to_xyz @ seen / np.array([0.9505, 1.0, 1.089])
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16.0 / 116.0)
    return np.array([116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])])


@pytest.mark.parametrize("kind", ["", *sorted(SIMULATIONS)])
def test_lights_can_be_told_apart_by_people_with_any_colour_vision(kind: str) -> None:
    for one, other in combinations(STATE_COLOURS.values(), 2):
        assert np.linalg.norm(lab(one, kind) - lab(other, kind)) > 15.0


@pytest.mark.parametrize("kind", ["", *sorted(SIMULATIONS)])
def test_first_five_tasks_can_be_told_apart_by_people_with_any_colour_vision(kind: str) -> None:
    for one, other in combinations(TASK_COLOURS[:5], 2):
        assert np.linalg.norm(lab(one, kind) - lab(other, kind)) > 10.0


def test_no_task_looks_like_a_light() -> None:
    for task in TASK_COLOURS:
        for state in RobotState:
            assert np.linalg.norm(lab(task, "") - lab(STATE_COLOURS[state], "")) > 20.0


@pytest.mark.parametrize("ground", [*TASK_COLOURS, *STATE_COLOURS.values()])
def test_words_on_bars_have_contrast(ground: Colour) -> None:
    def luminance(colour: Colour) -> float:
        parts = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in (x / 255.0 for x in colour)]
        return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]

    ink = readable_on(ground)
    assert ink in (INK, WHITE)
    light, dark = sorted((luminance(ground), luminance(ink)), reverse=True)
    # WCAG 2.1 asks 3 of large or bold words.
    assert (light + 0.05) / (dark + 0.05) >= 3.0


def test_task_colours_follow_the_records_order_and_stay() -> None:
    early, late = TaskColours.of(views.patrol(10.0)), TaskColours.of(views.patrol(181.0))
    for number, task in enumerate(("wander", "border_protection", "report")):
        assert early[task] == late[task] == TASK_COLOURS[number]


def test_task_colours_begin_again_after_the_last() -> None:
    colours = TaskColours(f"task{number}" for number in range(len(TASK_COLOURS) + 1))
    assert colours["task0"] == colours[f"task{len(TASK_COLOURS)}"]


def test_mix_goes_from_one_colour_to_the_other() -> None:
    assert mix((0, 100, 200), (100, 200, 0), 0.0) == (0, 100, 200)
    assert mix((0, 100, 200), (100, 200, 0), 0.25) == (25, 125, 150)
    assert mix((0, 100, 200), (100, 200, 0), 1.0) == (100, 200, 0)
