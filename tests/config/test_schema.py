"""The schema as data: it and the readers know the same names, and so do the grammars written from it."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from types import ModuleType
from typing import Any, Callable, Dict, Iterator, List, Sequence, Tuple

import pytest
import yaml
from lxml import etree

import rqt_mrta_py.config.schema
from rqt_mrta_py.config.discovery import manifest
from rqt_mrta_py.config.scenario.scenario_file import read_scenario
from rqt_mrta_py.config.schema.application_form import APPLICATION_FILE
from rqt_mrta_py.config.schema.architecture_form import ARCHITECTURE_FILE
from rqt_mrta_py.config.schema.exports import EXPORTS
from rqt_mrta_py.config.schema.forms import Content, ElementForm, XmlForm
from rqt_mrta_py.config.schema.relax_ng import HIGHEST_NUMBER, relax_ng
from rqt_mrta_py.config.schema.shipped import XML_FORMS, grammars
from rqt_mrta_py.config.tasks.tasks_file import read_tasks
from rqt_mrta_py.config.xml.application import read_application
from rqt_mrta_py.config.xml.architecture import read_architecture
from rqt_mrta_py.errors import ConfigError
from tests.conftest import ROOT

READERS: Dict[str, Callable[[str], Any]] = {
    "architecture": lambda text: read_architecture(text, "a.xml", "a"),
    "application": lambda text: read_application(text, "a.xml", "a"),
}
SAMPLES = {
    Content.TEXT: "text",
    Content.ID: "name",
    Content.TOPIC: "/x/@robot_id@/@task_id@",
    Content.MESSAGE_TYPE: "p/M",
    Content.FIELD: "header/frame_id",
    Content.WHOLE: "3",
    Content.SECONDS: "0.5",
}
FORMS = {form.name: form for form in XML_FORMS}
DATA = ROOT / "tests" / "data" / "config"
SOUND = {
    "architecture": [
        DATA / "appendix_a_architecture.xml",
        DATA / "final_architecture.xml",
        *sorted((ROOT / "plugins" / "architectures").glob("*/rqt_mrta.xml")),
    ],
    "application": [
        DATA / "appendix_b_application.xml",
        *sorted((ROOT / "plugins" / "applications").glob("*/rqt_mrta.xml")),
    ],
}


def maximal(form: XmlForm, numbers: Sequence[int] = (0,)) -> etree._Element:
    """Build a document in which every element of a form stands, numbered ones as often as told, groups in groups."""
    root = etree.Element(form.root.name, format=form.format)
    _Filler(form, numbers).fill(root, form.root, 2)
    return root


class _Filler:
    def __init__(self, form: XmlForm, numbers: Sequence[int]) -> None:
        self._form = form
        self._numbers = numbers

    def fill(self, node: etree._Element, element: ElementForm, depth: int) -> None:
        for child in element.children:
            for name in self._names(child, self._numbers):
                self._put(node, name, child, depth)
        if element.group and depth:
            for number, child in enumerate(self._form.groups[element.group]):
                if child.name != "array" or element.name != "config":
                    for name in self._names(child, [20 * other + number for other in self._numbers]):
                        self._put(node, name, child, depth - 1)

    def _names(self, element: ElementForm, numbers: Sequence[int]) -> List[str]:
        numbered = [f"{element.name}_{number}" for number in numbers] if element.numbered else []
        return [*([element.name] if element.plain else []), *numbered]

    def _put(self, node: etree._Element, name: str, element: ElementForm, depth: int) -> None:
        inner = etree.SubElement(node, name)
        if element.content is Content.ELEMENTS:
            self.fill(inner, element, depth)
        elif element.content is not Content.NOTHING:
            inner.text = _text(element, inner)
        if element.name in ("params", "array"):
            # What an array needs beside it.
            size = etree.SubElement(inner, "param_99")
            etree.SubElement(size, "name").text = "size"


def _text(element: ElementForm, node: etree._Element) -> str:
    if element.spellings:
        return element.spellings[-1]
    if element.name in ("config_id", "launch_id"):
        kind = element.name[:-3]
        return f"id_{kind}_0"
    if element.name in ("id", "name"):
        # Ids and names are unique among their siblings.
        owner = node.getparent()
        return SAMPLES[element.content] if owner is None or "_" not in owner.tag else f"{_spoken(element)}_{owner.tag}"
    return "7" if element.name in ("value", "default") else SAMPLES[element.content]


def _spoken(element: ElementForm) -> str:
    return "/name" if element.content is Content.TOPIC else element.name


def text_of(root: etree._Element) -> str:
    return etree.tostring(root, encoding="unicode")


def validator(name: str) -> etree.RelaxNG:
    return etree.RelaxNG(etree.fromstring(grammars()[f"{name}.rng"].encode()))


def problems_of(name: str, root: etree._Element) -> List[str]:
    try:
        READERS[name](text_of(root))
    except ConfigError as error:
        return [str(problem) for problem in error.problems]
    return []


@pytest.mark.parametrize("name", FORMS)
def test_a_file_with_every_element_of_the_schema_is_read_and_valid(name: str) -> None:
    root = maximal(FORMS[name], (0, 1, 4))

    assert problems_of(name, root) == []
    grammar = validator(name)
    assert grammar.validate(root), grammar.error_log
    spec = READERS[name](text_of(root))
    if name == "architecture":
        assert all(getattr(spec, kind) for kind in ("busy_robots", "idle_robots", "completed_tasks", "widgets"))
        assert str(spec.taxonomy) == "MT-MR-TA"
    assert len(spec.configs) == len(spec.launches) == 3


@pytest.mark.parametrize("name", FORMS)
def test_an_element_or_attribute_that_the_schema_does_not_know_is_a_problem_anywhere(name: str) -> None:
    grammar = validator(name)
    whole = maximal(FORMS[name])
    # Of the dissertation's url, and of the other flavour's empty element, readers look at nothing.
    places = [node for node in whole.iter() if node.tag == name or node.tag not in [*FORMS, "url"]]
    for place in places:
        stray = etree.SubElement(place, "qqq")
        assert problems_of(name, whole), place.tag
        assert not grammar.validate(whole), place.tag
        place.remove(stray)
        place.set("qqq", "1")
        assert problems_of(name, whole), place.tag
        assert not grammar.validate(whole), place.tag
        del place.attrib["qqq"]
    assert problems_of(name, whole) == []


@pytest.mark.parametrize("name", FORMS)
def test_what_readers_offer_instead_of_an_unknown_name_is_what_the_schema_lists(name: str) -> None:
    form = FORMS[name]
    listed = {
        path: {known for child in form.inside(element) for known in child.names}
        for path, element in form.walk()
        if element.content is Content.ELEMENTS
    }
    for path, names in listed.items():
        assert offered(name, path) == names, path


def offered(name: str, path: str) -> set:
    """Ask a reader what it would accept within the element of a path, by an element that nobody could mean."""
    node = root = etree.Element("rqt_mrta")
    for step in path.split("/"):
        node = etree.SubElement(node, step.replace("<n>", "0"))
    etree.SubElement(node, "ZZZZZZZZZZZZ").text = "x"
    etree.SubElement(node, "name").text = "x"
    said = next(problem for problem in problems_of(name, root) if "ZZZZZZZZZZZZ" in problem)
    return {known.replace("<number>", "<n>") for known in said.partition("accepted: ")[2].split(", ")}


@pytest.mark.parametrize(("name", "path"), [(name, path) for name, paths in SOUND.items() for path in paths], ids=str)
def test_sound_files_are_valid(name: str, path: Path) -> None:
    grammar = validator(name)

    assert grammar.validate(etree.fromstring(path.read_bytes())), grammar.error_log


@pytest.mark.parametrize(
    "text",
    [
        "<rqt_mrta><architecture><name>\n A\n  b </name><robots/><tasks> </tasks></architecture><application/>"
        "</rqt_mrta>",
        "<rqt_mrta format=' architecture '><configs/><widgets/><architecture><name>A</name></architecture></rqt_mrta>",
        "<rqt_mrta><architecture><name>A</name><robots><busy_robots><topic><name/><type> </type>"
        "<queue_size>0</queue_size></topic></busy_robots></robots></architecture><configs><config_4/></configs></rqt_mrta>",
        "<rqt_mrta><architecture><name>A</name><robots><busy_robots><topic_1/><topic/><topic/></busy_robots></robots>"
        "<!-- c --></architecture></rqt_mrta>",
    ],
)
def test_what_readers_pass_over_is_valid(text: str) -> None:
    assert READERS["architecture"](text).name.startswith("A")
    assert validator("architecture").validate(etree.fromstring(text))


@pytest.mark.parametrize(
    "text",
    [
        "<rqt_mrta><architecture><name> </name></architecture></rqt_mrta>",
        "<rqt_mrta><architecture/></rqt_mrta>",
        "<rqt_mrta format='application'><architecture><name>A</name></architecture></rqt_mrta>",
        "<rqt_mrta><architecture><name>A</name></architecture><application><name>A</name></application></rqt_mrta>",
        "<rqt_mrta><architecture><name>A</name>stray</architecture></rqt_mrta>",
        "<rqt_mrta><architecture><name>A</name></architecture><configs><config><id>a</id></config></configs></rqt_mrta>",
        "<rqt_mrta><architecture><name>A</name></architecture><configs><config_0/><config_1><id>a b</id></config_1>"
        "</configs></rqt_mrta>",
        *(
            "<rqt_mrta><architecture><name>A</name><robots><busy_robots><topic><name>/a</name><type>p/M</type>"
            f"<field>f</field><{wrong}</topic></busy_robots></robots></architecture></rqt_mrta>"
            for wrong in (
                "timeout>0</timeout>",
                "timeout>inf</timeout>",
                "timeout>1_0</timeout>",
                "timeout>\u0661</timeout>",
                "queue_size>-1</queue_size>",
                "robot_field>a.b</robot_field>",
            )
        ),
    ],
)
def test_what_readers_refuse_is_not_valid(text: str) -> None:
    with pytest.raises(ConfigError):
        READERS["architecture"](text)
    assert not validator("architecture").validate(etree.fromstring(text))


def test_numbers_are_listed_up_to_a_bound() -> None:
    def document(number: int) -> etree._Element:
        robot = f"<robots><robot_{number}><id>a</id></robot_{number}></robots>"
        return etree.fromstring(f"<rqt_mrta><application><name>A</name>{robot}</application></rqt_mrta>")

    grammar = etree.RelaxNG(etree.fromstring(relax_ng(APPLICATION_FILE).encode()))
    assert grammar.validate(document(HIGHEST_NUMBER))
    assert not grammar.validate(document(HIGHEST_NUMBER + 1))


def test_every_element_of_the_schema_is_documented() -> None:
    for form in (ARCHITECTURE_FILE, APPLICATION_FILE):
        for path, element in form.walk():
            assert element.summary.endswith("."), path
            assert element.reader or element.content in (Content.ELEMENTS, Content.NOTHING), path


def test_export_attributes_are_those_that_manifests_are_read_for() -> None:
    assert {entry.name for entry in EXPORTS} == set(manifest._ATTRIBUTES)


def page() -> ModuleType:
    specification = importlib.util.spec_from_file_location("make_config", ROOT / "docs" / "make_config.py")
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def test_the_reference_and_the_grammars_are_fresh() -> None:
    """If this fails, run: python docs/make_config.py."""
    assert (ROOT / "docs" / "config.md").read_text(encoding="utf-8") == page().render()
    folder = Path(rqt_mrta_py.config.schema.__path__[0])
    shipped = {
        path.name: path.read_text(encoding="utf-8") for path in folder.iterdir() if path.suffix in (".rng", ".json")
    }
    assert shipped == grammars()


def yaml_validator(name: str) -> Any:
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads(grammars()[f"{name}.schema.json"])
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def yaml_cases() -> Iterator[Tuple[str, str, bool]]:
    base = "arena: {min_x: 0, min_y: 0, max_x: 1, max_y: 1}\nrobots: [{id: a, start: {x: 0, y: 0}}]\n"
    yield "tasks", "tasks: [{id: a, kind: b}]", True
    yield "tasks", "tasks: [{id: a, kind: b, place: null, robots: 2, data: {x: [1]}, expected_duration: 1.5}]", True
    yield "tasks", "tasks: []", True
    yield "tasks", "tasks: [{id: a}]", False
    yield "tasks", "tasks: [{id: a, kind: b, robots: 0}]", False
    yield "tasks", "tasks: [{id: a, kind: b, colour: red}]", False
    yield "tasks", "tasks: [{id: a, kind: b, expected_duration: 0}]", False
    yield "tasks", "tasks: [{id: 7, kind: b}]", False
    yield "tasks", "tasks: [{id: ' ', kind: b}]", False
    yield "scenario", base, True
    yield "scenario", f"{base}radio: {{kind: loss, rate: 0.1}}\nobstacles: null", True
    yield "scenario", f"{base}events: [{{time: 1, kind: robot_slows, robot: a, parameters: {{factor: 0.5}}}}]", True
    parted = "{time: 1, kind: radio_partitions, parameters: {groups: [[a]]}}"
    yield "scenario", f"{base}events: [{parted}, {{time: 2, kind: radio_heals}}]", True
    yield "scenario", f"{base}events: [{{time: 1, kind: radio_heals, robot: a}}]", False
    yield "scenario", f"{base}events: [{{time: 1, kind: robot_slows, robot: a, parameters: {{factor: 2}}}}]", False
    yield "scenario", f"{base}events: [{{time: 1, kind: robot_stop, robot: a}}]", False
    yield "scenario", f"{base}events: [{{time: 1, kind: robot_stops}}]", False
    yield "scenario", f"{base}obstacles: [{{id: a, x: 0, y: 0, size: [1, 2]}}]", False
    yield "scenario", f"{base}obstacles: [{{id: a, x: 0, y: 0, shape: ball, size: [1, 1, 1]}}]", False
    yield "scenario", f"{base}bodies: [{{id: a, kind: can, x: 0, y: 0, size: [1, 1, 1], mass: 0.1}}]", True
    yield "scenario", f"{base}bodies: [{{id: a, x: 0, y: 0, size: [1, 1, 1], mass: 0}}]", False
    yield "scenario", f"{base}bodies: [{{id: a, size: [1, 1, 1]}}]", False
    yield "scenario", f"{base}control_rate: 20.5", False
    yield "scenario", f"{base}sped: 2", False
    yield "scenario", "robots: []", False


@pytest.mark.parametrize(("name", "text", "is_sound"), list(yaml_cases()))
def test_readers_and_json_schemas_agree(name: str, text: str, is_sound: bool) -> None:
    readers = {"tasks": lambda: read_tasks(text, "t.yaml"), "scenario": lambda: read_scenario(text, "s.yaml")}

    assert yaml_validator(name).is_valid(yaml.safe_load(text)) is is_sound
    if is_sound:
        assert readers[name]() is not None
    else:
        with pytest.raises(ConfigError):
            readers[name]()


@pytest.mark.parametrize("name", ["tasks", "scenario"])
def test_yaml_files_of_our_applications_are_valid(name: str) -> None:
    paths = sorted((ROOT / "plugins" / "applications").glob(f"*/{name}.yaml"))

    assert paths
    for path in paths:
        assert yaml_validator(name).is_valid(yaml.safe_load(path.read_text(encoding="utf-8"))), path
