"""The page as a person uses it, in a headless Chromium."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Dict, Iterator, Tuple

import pytest

from rqt_mrta_py.render.body_keeper import BodyPlace, BodyTrack
from rqt_mrta_py.render.report import report_html
from tests.render.report.browser import Browser, Tab, require_browser
from tests.render.report.missions import empty_mission, hostile_mission, usual_mission
from tests.render.views import START

MISSIONS = {"usual": usual_mission, "hostile": hostile_mission, "empty": empty_mission}

_CLOCK = "document.getElementById('now').textContent"
_WINDOW = "document.getElementById('axis').dataset.window.split(' ').map(Number)"
_PLOT = """(() => {
  const box = document.getElementById('rows').getBoundingClientRect();
  const ground = document.querySelector('#overview .ground').getBoundingClientRect();
  return {left: ground.left, right: ground.right, top: box.top, bottom: box.bottom};
})()"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    require_browser()
    with Browser(tmp_path_factory.mktemp("browser")) as started:
        yield started


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Dict[str, Path]:
    folder = tmp_path_factory.mktemp("pages")
    for name, mission in MISSIONS.items():
        (folder / f"{name}.html").write_text(report_html(mission()), encoding="utf-8")
    return {name: folder / f"{name}.html" for name in MISSIONS}


@pytest.fixture(scope="module")
def opened(browser: Browser, pages: Dict[str, Path]) -> Tab:
    return browser.open(pages["usual"])


@pytest.fixture
def tab(opened: Tab) -> Tab:
    """Give the usual page as it is after loading, timeline in sight."""
    opened.to_front()
    opened.run("document.getElementById('mission').scrollIntoView({behavior: 'instant'})")
    opened.run("document.getElementById('axis').focus({preventScroll: true})")
    for key in ("Escape", "0", "Home"):
        opened.press(key)
    return opened


def at(tab: Tab, time: float, row: str) -> Tuple[float, float]:
    """Find the place of a moment [s] in a robot's or task's row, the window being the whole mission of 90 s."""
    plot: Dict[str, float] = tab.run(_PLOT)
    names = "[...document.querySelectorAll('#rows text.name')]"
    box = tab.run(
        f"(() => {{ const r = {names}.find((each) => each.textContent === '{row}').getBoundingClientRect();"
        " return [r.top, r.bottom]; })()"
    )
    return plot["left"] + time / 90.0 * (plot["right"] - plot["left"]), sum(box) / 2.0


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("name", sorted(MISSIONS))
def test_a_page_loads_without_complaints_and_asks_nobody_for_anything(
    browser: Browser, pages: Dict[str, Path], name: str, scheme: str
) -> None:
    tab = browser.open(pages[name], scheme=scheme)
    assert tab.run("document.documentElement.className").split()[-1] == "ready"
    assert tab.complaints() == []


def test_nothing_a_bag_brings_comes_alive(browser: Browser, pages: Dict[str, Path]) -> None:
    tab = browser.open(pages["hostile"])
    for key in ("n", "ArrowDown", "e", "+"):
        tab.run("document.getElementById('axis').focus()")
        tab.press(key)
    tab.run("document.querySelectorAll('details').forEach((each) => { each.open = true; })")
    for x in range(20, 1400, 90):
        for y in range(100, 900, 100):
            tab.mouse("mouseMoved", x, y)
    tab.settle()
    assert tab.run("typeof window.broken") == "undefined"
    assert tab.run("document.querySelectorAll('img, iframe, object, [onload], [onerror]').length") == 0
    assert tab.run("document.scripts.length") == 2
    assert tab.complaints() == []


def test_what_would_come_alive_is_stopped_by_the_page_itself(browser: Browser, tmp_path: Path) -> None:
    """Were something not escaped, the page's own policy would stop it: tried with markup put in on purpose."""
    page = tmp_path / "let_in.html"
    text = report_html(usual_mission())
    page.write_text(
        text.replace("<main>", "<main><img src='x' onerror='window.broken=1'><script>window.broken=2</script>")
    )
    tab = browser.open(page)
    assert tab.run("typeof window.broken") == "undefined"
    assert any("Content Security Policy" in each for each in tab.complaints())


def test_an_incident_leads_to_its_moment(tab: Tab) -> None:
    tab.run("document.querySelectorAll('.incident .when')[1].click()")
    tab.settle()
    assert tab.run(_CLOCK) == "60.0 s"
    assert tab.run("location.hash") == "#t=60.000&incident=1"
    assert tab.run("document.querySelector('.team[aria-pressed=true] b').textContent") == "robot3"
    box = tab.run("document.getElementById('mission').getBoundingClientRect().top")
    assert tab.run("new Promise((done) => setTimeout(() => done(1), 1))") == 1
    assert isinstance(box, (int, float))


def test_a_link_to_a_moment_opens_there(browser: Browser, pages: Dict[str, Path]) -> None:
    tab = browser.open(pages["usual"], hash_="#t=12.5")
    assert tab.run(_CLOCK) == "12.5 s"


def test_the_arena_shows_a_body_until_it_was_taken_away(browser: Browser, tmp_path: Path) -> None:
    lying = BodyPlace(START, 1.0, 0.5, 0.0, 0.0, held=False)
    places = (lying, lying._replace(time=START + 20.0, held=True), lying._replace(time=START + 40.0, is_there=False))
    can = BodyTrack("can", "paper", 0.4, 0.1, places)
    page = tmp_path / "taken.html"
    page.write_text(report_html(replace(usual_mission(), bodies=(can,))), encoding="utf-8")
    shown = {}
    for time in (10.0, 30.0, 50.0):
        tab = browser.open(page, hash_=f"#t={time}")
        shown[time] = tab.run("[...document.querySelectorAll('[data-body]')].map((each) => each.getAttribute('class'))")
    assert shown == {10.0: ["body b0"], 30.0: ["body b0 held"], 50.0: []}


def test_keys_move_the_moment(tab: Tab) -> None:
    told = []
    for key, shift in (("ArrowRight", False), ("ArrowRight", True), ("ArrowLeft", False), ("End", False), ("p", False)):
        tab.press(key, shift)
        told.append(tab.run(_CLOCK))
    assert told == ["1.0 s", "11.0 s", "10.0 s", "90.0 s", "60.0 s"]


def test_a_screen_reader_is_told_the_moment_and_the_row(tab: Tab) -> None:
    tab.press("End")
    slider = "document.getElementById('axis').getAttribute('{}')"
    assert tab.run(slider.format("role")) == "slider"
    assert tab.run(slider.format("aria-valuenow")) == "90.0"
    assert "robot3 offline" in tab.run(slider.format("aria-valuetext"))
    assert "robot1 busy with border_protection" in tab.run(slider.format("aria-valuetext"))
    tab.press("ArrowDown")
    assert tab.run("document.getElementById('said').textContent").startswith("robot1, 90.0 s. busy since")


def test_a_click_chooses_a_moment_and_a_row(tab: Tab) -> None:
    tab.click(*at(tab, 45.0, "robot2"))
    assert abs(float(tab.run(_CLOCK).split()[0]) - 45.0) < 0.3
    assert tab.run("document.querySelector('.team[aria-pressed=true] b').textContent") == "robot2"


def test_zooming_and_panning_move_the_window(tab: Tab) -> None:
    whole = tab.run(_WINDOW)
    assert (whole[0], whole[-1]) == (0, 90)
    x, y = at(tab, 45.0, "robot2")
    tab.mouse("mouseWheel", x, y, deltaX=0, deltaY=-400, modifiers=2)
    tab.settle()
    near = tab.run(_WINDOW)
    assert near[0] > 10
    assert near[-1] < 80
    tab.drag((x, y), (x + 120, y))
    before = tab.run(_WINDOW)
    assert before[0] < near[0]
    assert tab.run(_CLOCK) == "0.0 s"
    tab.press("]")
    assert tab.run(_WINDOW)[0] > before[0]
    tab.press("0")
    assert tab.run(_WINDOW) == whole
    tab.click(x, y, count=2)
    assert tab.run(_WINDOW)[0] > 10


def test_times_do_not_run_into_the_name_of_their_axis(browser: Browser, tmp_path: Path) -> None:
    """From a quarter of an hour on both are long, ``time [h:m:s]`` and ``0:00:00``; short names leave little room."""
    usual, end = usual_mission(), START + 1800.0
    record = replace(usual.view.record, end=end, tasks=(), allocations=())
    page = tmp_path / "long.html"
    page.write_text(report_html(replace(usual, view=replace(usual.view, record=record, now=end), explanations=())))
    tab = browser.open(page, hash_="#t=900")
    words = "document.querySelectorAll('#axis text')"
    assert tab.run(f"{words}[0].textContent") == "time [h:m:s]"
    name, first = (
        tab.run(f"(() => {{ const b = {words}[{n}].getBoundingClientRect(); return [b.left, b.right]; }})()")
        for n in (0, 1)
    )
    assert name[1] < first[0]


def test_the_overview_moves_the_window_too(tab: Tab) -> None:
    plot: Dict[str, float] = tab.run(_PLOT)
    y = tab.run("document.getElementById('overview').getBoundingClientRect().top") + 10
    width = plot["right"] - plot["left"]
    tab.drag((plot["left"] + 0.5 * width, y), (plot["left"] + 0.75 * width, y))
    window = tab.run(_WINDOW)
    assert window == pytest.approx([45.0, 67.5], abs=0.5)


def test_hovering_tells_of_what_lies_below(tab: Tab) -> None:
    tab.mouse("mouseMoved", *at(tab, 30.0, "robot3"))
    tab.settle()
    tip = tab.run("document.querySelector('.tip.shown').textContent")
    # The allocation lasts from 5.2 s to 63 s on the stream's clock, which begins at 1 s.
    assert "border_protection: 4.2 s to 62.0 s (57.8 s), lost" in tip
    robot = tab.run(
        "(() => { const r = document.querySelector('#arena .robot .ring').getBoundingClientRect();"
        " return [r.left + r.width / 2, r.top + r.height / 2]; })()"
    )
    tab.mouse("mouseMoved", *robot)
    tab.settle()
    assert tab.run("document.querySelector('.tip.shown b').textContent").startswith("robot")


def test_the_arena_shows_robots_where_they_were(tab: Tab) -> None:
    ring = "document.querySelector('#arena [data-robot=\"0\"] .ring')"
    before: Any = tab.run(f"[{ring}.getAttribute('cx'), {ring}.getAttribute('cy')]")
    for _ in range(2):
        tab.press("ArrowRight", shift=True)
    assert tab.run(f"[{ring}.getAttribute('cx'), {ring}.getAttribute('cy')]") != before
    assert tab.run("document.querySelectorAll('#arena .light.offline').length") == 0
    tab.press("End")
    assert tab.run("document.querySelectorAll('#arena .light.offline').length") == 1
    assert tab.run("document.querySelectorAll('#arena .obstacle').length") == 3


def test_playing_goes_on_until_stopped(tab: Tab) -> None:
    tab.press(" ")
    tab.run(
        "new Promise((done) => { const look = () => parseFloat("
        + _CLOCK
        + ") > 0.2 ? done(1) : requestAnimationFrame(look); look(); })"
    )
    tab.press(" ")
    told = tab.run(_CLOCK)
    tab.settle()
    assert tab.run(_CLOCK) == told
    assert tab.run("document.getElementById('play').getAttribute('aria-label')") == "Play (Space)"


def test_a_ground_leads_to_its_moment(tab: Tab) -> None:
    """The second ground of the task that is explained is of 65.2 s."""
    tab.run("document.querySelectorAll('#why tbody .when')[4].click()")
    tab.settle()
    assert tab.run(_CLOCK) == "65.2 s"
    assert tab.run("location.hash") == "#t=65.200"


def test_parts_of_the_timeline_can_be_put_away(tab: Tab) -> None:
    box = "document.querySelectorAll('#parts input')[1]"
    tab.run(f"{box}.click()")
    tab.settle()
    assert tab.run("document.querySelectorAll('#rows .diamond').length") == 0
    tab.run(f"{box}.click()")
    tab.settle()
    assert tab.run("document.querySelectorAll('#rows .diamond').length") == 3


def test_the_theme_is_the_systems_until_the_user_says_otherwise(tab: Tab) -> None:
    ground = "getComputedStyle(document.body).backgroundColor"
    light = tab.run(ground)
    tab.media("dark")
    dark = tab.run(ground)
    assert dark != light
    tab.run("document.getElementById('theme').click()")
    assert tab.run(ground) == light
    tab.media("light")
    tab.run("document.getElementById('theme').click()")
    assert tab.run(ground) == dark
    tab.run("document.getElementById('theme').click()")
    assert tab.run(ground) == light


def test_on_paper_the_whole_mission_stands(tab: Tab, tmp_path: Path) -> None:
    x, y = at(tab, 45.0, "robot2")
    tab.mouse("mouseWheel", x, y, deltaX=0, deltaY=-400, modifiers=2)
    tab.settle()
    window = tab.run(_WINDOW)
    dark = [{"name": "prefers-color-scheme", "value": "dark"}]
    tab.call("Emulation.setEmulatedMedia", media="print", features=dark)
    tab.settle()
    on_paper = tab.run(_WINDOW)
    assert (on_paper[0], on_paper[-1]) == (0, 90)
    assert tab.run("getComputedStyle(document.querySelector('nav')).display") == "none"
    assert tab.run("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    tab.call("Emulation.setEmulatedMedia", media="", features=[])
    tab.settle()
    assert tab.run(_WINDOW) == window
    tab.paper(tmp_path / "report.pdf")
    assert (tmp_path / "report.pdf").read_bytes().startswith(b"%PDF")
    assert tab.complaints() == []


def test_a_narrow_window_shows_everything_below_one_another(browser: Browser, pages: Dict[str, Path]) -> None:
    tab = browser.open(pages["usual"], width=420, height=800)
    assert tab.run("document.documentElement.scrollWidth") <= 420
    assert tab.complaints() == []
