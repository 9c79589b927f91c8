"""Definitions of plots, read as the programs read them that they are for."""

from __future__ import annotations

from typing import Dict, List
from xml.etree import ElementTree

import pytest
from mrta_alliance.inner_life import FLAGS
from mrta_alliance.plots import AlliancePlots
from mrta_alliance.xml_text import plain

from rqt_mrta_py.hooks import ExporterSetup
from tests.plugins.mrta_alliance.test_figures import MISSION, RECORD, felt


def exported(*heard: object) -> Dict[str, bytes]:
    plots = AlliancePlots(ExporterSetup(MISSION))
    for message in heard:
        plots.hear(message)  # type: ignore[arg-type]
    return dict(plots.export(RECORD))


class Settings:
    """Reads values as Qt's settings give them to rqt_multiplot: by path, a missing one as its default."""

    def __init__(self, content: bytes) -> None:
        self._root = ElementTree.fromstring(content)
        assert self._root.tag == "rqt_multiplot"
        self.read: List[str] = []

    def groups(self, path: str) -> List[str]:
        """List child groups, in the order of their names, as settings keep them."""
        found = self._root.find(path)
        return [] if found is None else sorted(child.tag for child in found if len(child))

    def value(self, path: str) -> str:
        """Give a value that must be there."""
        element = self._root.find(path)
        assert element is not None, path
        assert len(element) == 0, path
        self.read.append(path)
        return element.text or ""

    def leaves(self) -> int:
        return sum(len(element) == 0 for element in self._root.iter())


COLOURS = ("background_color", "foreground_color")
SWITCHES = ("link_cursor", "link_scale", "track_points")
STYLE_SWITCHES = ("lines_interpolate", "render_antialias", "steps_invert")


def check(settings: Settings) -> Dict[str, List[str]]:
    """Read everything that the ``load`` functions of rqt_multiplot read, with its type; nothing else may be there.

    Returns:
        The fields of each plot's curves, by the plot's title, from top to bottom.
    """
    for name in COLOURS:
        assert len(settings.value(f"table/{name}")) == len("#rrggbb")
    for name in SWITCHES:
        assert settings.value(f"table/{name}") in ("true", "false")
    found = {}
    for row in settings.groups("table/plots"):
        assert settings.groups(f"table/plots/{row}") == ["column_0"]
        plot = f"table/plots/{row}/column_0"
        assert settings.value(f"{plot}/legend/visible") in ("true", "false")
        assert float(settings.value(f"{plot}/plot_rate")) > 0
        for axis in ("x_axis", "y_axis"):
            title = f"{plot}/axes/axes/{axis}"
            assert settings.value(f"{title}/custom_title")
            assert settings.value(f"{title}/title_type") in ("0", "1")
            assert settings.value(f"{title}/title_visible") in ("true", "false")
        curves = settings.groups(f"{plot}/curves")
        found[settings.value(f"{plot}/title")] = [_check_curve(settings, f"{plot}/curves/{curve}") for curve in curves]
    assert len(settings.read) == settings.leaves()
    return found


def _check_curve(settings: Settings, curve: str) -> str:
    for axis in ("x_axis", "y_axis"):
        where = f"{curve}/axes/{axis}"
        assert settings.value(f"{where}/topic").startswith("/")
        assert settings.value(f"{where}/type") == "alliance_msgs/Motivation"
        assert settings.value(f"{where}/field_type") == "0"
        scale = {
            name: float(settings.value(f"{where}/scale/{name}"))
            for name in ("absolute_minimum", "absolute_maximum", "relative_minimum", "relative_maximum", "type")
        }
        assert scale["type"] in (0, 1, 2)
        assert scale["absolute_minimum"] < scale["absolute_maximum"]
        assert scale["relative_minimum"] < scale["relative_maximum"]
    assert settings.value(f"{curve}/axes/x_axis/field") == "header/stamp"
    assert len(settings.value(f"{curve}/color/custom_color")) == len("#rrggbb")
    assert settings.value(f"{curve}/color/type") == "1"
    for name in ("circular_buffer_capacity", "time_frame_length", "type"):
        assert int(settings.value(f"{curve}/data/{name}")) >= 0
    for name in STYLE_SWITCHES:
        assert settings.value(f"{curve}/style/{name}") in ("true", "false")
    for name in ("pen_style", "pen_width", "sticks_baseline", "sticks_orientation", "type"):
        assert int(settings.value(f"{curve}/style/{name}")) >= 0
    assert int(settings.value(f"{curve}/subscriber_queue_size")) > 0
    assert settings.value(f"{curve}/title")
    return settings.value(f"{curve}/axes/y_axis/field")


def test_files_are_named_as_the_original_node_names_them() -> None:
    assert list(exported()) == [
        "b-motivations.xml",
        "b-patrol-detailed-motivation.xml",
        "b-inspect-detailed-motivation.xml",
        "a-motivations.xml",
        "a-patrol-detailed-motivation.xml",
        "a-inspect-detailed-motivation.xml",
    ]


def test_a_robots_plots_are_its_behaviour_sets_with_motivation_and_threshold() -> None:
    assert check(Settings(exported()["a-motivations.xml"])) == {
        "/a/alliance/motivation/patrol": ["motivation", "threshold"],
        "/a/alliance/motivation/inspect": ["motivation", "threshold"],
    }


def test_the_detailed_plots_are_the_seven_of_rqt_alliance() -> None:
    assert check(Settings(exported()["a-patrol-detailed-motivation.xml"])) == {
        "/a/alliance/patrol/motivation": ["motivation", "threshold"],
        "/a/alliance/patrol/impatience": ["impatience"],
        **{f"/a/alliance/patrol/{flag}": [flag] for flag in FLAGS},
    }


def test_motivation_is_blue_and_solid_and_the_threshold_red_and_dashed() -> None:
    settings = Settings(exported()["a-motivations.xml"])
    curves = [f"table/plots/row_0/column_0/curves/curve_{number}" for number in (0, 1)]
    assert [settings.value(f"{curve}/color/custom_color") for curve in curves] == ["#0000ff", "#ff0000"]
    assert [settings.value(f"{curve}/style/pen_style") for curve in curves] == ["1", "2"]


def test_rows_keep_their_order_where_names_of_rows_are_read_as_texts() -> None:
    content = exported(*(felt(11.0, "new", f"t{number}") for number in range(12)))["new-motivations.xml"]
    assert list(check(Settings(content))) == [f"/new/alliance/motivation/t{number}" for number in range(12)]


def test_the_layout_shows_the_curves_that_were_heard_and_no_others() -> None:
    """PlotJuggler looks for what its ``xmlLoadState`` functions name, and asks where a curve is missing in the bag."""
    root = ElementTree.fromstring(exported(felt(11.0, "a", "patrol"))["plotjuggler_layout.xml"])
    assert (root.tag, root.get("version")) == ("root", "2.3.8")
    (window,) = root.findall("tabbed_widget")
    assert (window.get("parent"), window.get("name")) == ("main_window", "Main Window")
    assert [tab.get("tab_name") for tab in window.findall("Tab")] == ["a", "a patrol"]
    for splitter in window.iter("DockSplitter"):
        areas = splitter.findall("DockArea")
        assert splitter.get("orientation") == "-"
        assert int(splitter.get("count", "")) == len(areas) == len(splitter.get("sizes", "").split(";"))
        assert sum(map(float, splitter.get("sizes", "").split(";"))) == pytest.approx(1.0, abs=1e-3)
        assert all(len(area.findall("plot[@mode='TimeSeries']")) == 1 for area in areas)
    motivation = "/a/alliance/motivation/patrol"
    assert [curve.get("name") for curve in window.findall("Tab[2]//curve")] == [
        *(f"{motivation}/{field}" for field in ("motivation", "threshold", "impatience", *FLAGS)),
    ]
    assert window.find("currentTabIndex") is not None


def test_a_layout_of_very_many_behaviour_sets_has_a_tab_for_each_robot_only() -> None:
    root = ElementTree.fromstring(exported(*(felt(11.0, "a", f"t{n}") for n in range(21)))["plotjuggler_layout.xml"])
    assert [tab.get("tab_name") for tab in root.iter("Tab")] == ["a"]


def test_whatever_ids_hold_files_are_whole_and_stay_where_they_belong() -> None:
    files = exported(felt(11.0, "../<x>", "a&b\0"), felt(11.0, "../<x>", "a_b_"))
    new = [name for name in files if "x" in name.partition("-")[2].partition("motivation")[0]]
    assert new == [
        "__-_x_-motivations.xml",
        "__-_x_-a_b_-detailed-motivation.xml",
        "__-_x_-a_b__2-detailed-motivation.xml",
    ]
    for name in new:
        check(Settings(files[name]))
    assert plain("a\0\ud800b") == "a\ufffd\ufffdb"
