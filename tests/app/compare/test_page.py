from __future__ import annotations

from pathlib import Path

from lxml import html

from rqt_mrta_py.app.compare.comparison import compare
from rqt_mrta_py.app.compare.page import page
from rqt_mrta_py.app.compare.side import read_side
from tests.app.compare.summaries import allocation, folder, incident, summary

HOSTILE = '</title></svg><script>alert(1)</script><img src=x onerror=alert(2)> " onload="alert(3)'


def written(tmp_path: Path, name: str) -> str:
    first = summary(allocations=[allocation("dig", name, 2.0, 41.0)], robots=[name], statistics={name: 1})
    second = summary(
        tasks=[("dig", "done"), (name, "failed")],
        allocations=[allocation(name, "r2", 2.0, 41.0, name), allocation("dig", name, 2.0, 50.0, "lost")],
        incidents=[incident(name, "error", 3.0, [name], [name])],
        statistics={name: 2},
    )
    for content in (first, second):
        content["application"] = name
    a, b = folder(tmp_path, "a", first), folder(tmp_path, "b", second)
    return page(compare(read_side(a), read_side(b)), 1.0)


def test_the_page_says_what_differs(tmp_path: Path) -> None:
    text = written(tmp_path, "r1")
    tree = html.fromstring(text)
    (verdict,) = tree.xpath("//p[@role='status']/text()")
    assert verdict == "B is worse than the tolerances allow: incidents.error, tasks.done, tasks.failed"
    worse = tree.xpath("//tr[@class='worse']/td[1]/text()")
    assert worse == ["incidents.error", "tasks.done", "tasks.failed"]
    assert tree.xpath("//h3/text()") == ["dig", "haul", "r1"]
    assert tree.xpath("//*[name()='title']/text()") == [
        "r1: two missions compared",
        "r1: 1.0 to 40.0 s, done",
        "r1: 1.0 to 49.0 s, lost",
        "r2: 1.0 to 40.0 s, r1",
    ]


def test_missions_of_unknown_applications_are_named_after_their_folders(tmp_path: Path) -> None:
    content = {**summary(), "application": None}
    a, b = folder(tmp_path, "monday", content), folder(tmp_path, "tuesday", content)
    assert "<h1>monday and tuesday: two missions compared</h1>" in page(compare(read_side(a), read_side(b)), 1.0)


def test_texts_from_outside_are_inert_and_come_back_as_they_were(tmp_path: Path) -> None:
    text = written(tmp_path, HOSTILE)
    tree = html.fromstring(text)
    beside = tmp_path / "harmless"
    beside.mkdir()
    # As long, for a label that has no room in its bar is left out.
    harmless = html.fromstring(written(beside, "x" * len(HOSTILE)))
    assert [each.tag for each in tree.iter()] == [each.tag for each in harmless.iter()]
    assert not tree.xpath("//script | //img | //*[@onload or @onerror or @src or @href]")
    assert HOSTILE in tree.xpath("//h3/text()")
    (policy,) = tree.xpath("//meta[@http-equiv='Content-Security-Policy']/@content")
    assert policy == "default-src 'none'; style-src 'unsafe-inline'"


def test_the_page_is_the_same_every_time_and_asks_for_nothing_from_elsewhere(tmp_path: Path) -> None:
    first = written(tmp_path, "r1")
    mission = [read_side(tmp_path / name) for name in ("a", "b")]
    assert page(compare(*mission), 1.0) == first
    assert "http:" not in first
    assert "https:" not in first


def test_missions_without_messages_give_a_page(tmp_path: Path) -> None:
    empty = read_side(folder(tmp_path, "a", summary(time=(None, None), tasks=())))
    assert "B is not worse than the tolerances allow" in page(compare(empty, empty), 1.0)
