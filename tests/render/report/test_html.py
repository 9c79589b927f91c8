from __future__ import annotations

import json

import pytest

from rqt_mrta_py.render.report.html import Html, element, joined, json_block
from tests.render.report.missions import HOSTILE


def test_text_is_escaped_and_elements_are_not() -> None:
    made = element("p", "a < b & c", element("b", '"d"'), title="'e'")
    assert made == '<p title="&#x27;e&#x27;">a &lt; b &amp; c<b>&quot;d&quot;</b></p>'


def test_attributes_without_a_value_are_left_out_and_names_are_those_of_html() -> None:
    made = element("input", class_="x", aria_label="y", checked=True, title=None, disabled=False)
    assert made == '<input class="x" aria-label="y" checked>'


def test_markup_of_a_stranger_in_any_place_is_text() -> None:
    for text in HOSTILE:
        made = element("p", text, title=text)
        assert made.count("<") == 2
        assert made.count('"') == 2


def test_what_is_put_together_is_escaped_once() -> None:
    assert joined(["<", Html("<br>"), None, 3]) == "&lt;<br>3"


@pytest.mark.parametrize("text", HOSTILE)
def test_data_ends_no_script_and_comes_back(text: str) -> None:
    made = json_block("data", {text: text})
    inside = made[len('<script type="application/json" id="data">') : -len("</script>")]
    assert not set("<>&'") & set(inside)
    assert json.loads(inside) == {text: text}
