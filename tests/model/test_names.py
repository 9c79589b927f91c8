from __future__ import annotations

import pytest

from rqt_mrta_py.model import is_legal_name, resolve_name


@pytest.mark.parametrize(
    ("node", "name", "resolved"),
    [
        ("/no", "img", "/img"),
        ("/no", "/img", "/img"),
        ("/no", "~img", "/no/img"),
        ("/no", "img/raw", "/img/raw"),
        ("/no", "/img/raw", "/img/raw"),
        ("/no", "~img/raw", "/no/img/raw"),
        ("/ns/no", "img", "/ns/img"),
        ("/ns/no", "/img", "/img"),
        ("/ns/no", "~img", "/ns/no/img"),
    ],
)
def test_resolve_name_follows_ros(node: str, name: str, resolved: str) -> None:
    assert resolve_name(name, node) == resolved


def test_resolve_name_compares_remappings_in_resolved_form() -> None:
    assert resolve_name("img", "/ns/no", {"/ns/img": "camera"}) == "/ns/camera"
    assert resolve_name("~img", "/ns/no", {"~img": "/camera"}) == "/camera"
    assert resolve_name("img", "/ns/no", {"/img": "/camera"}) == "/ns/img"


@pytest.mark.parametrize("name", ["", "1st", "a b", "a//b", "a/", "a-b", "/robot1/ä"])
def test_names_that_ros_refuses_are_refused(name: str) -> None:
    assert not is_legal_name(name)
    with pytest.raises(ValueError, match="not a name that ROS accepts"):
        resolve_name(name, "/no")
