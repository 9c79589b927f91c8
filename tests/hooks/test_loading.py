"""Loading plugins from packages that are on no path."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Callable, Iterator

import pytest

from rqt_mrta_py.config.discovery.registration import Registration, RegistrationKind
from rqt_mrta_py.errors import HookError
from rqt_mrta_py.hooks.loading import load_plugin, load_plugins
from rqt_mrta_py.hooks.manager import PluginManager

GOOD = """
from rqt_mrta_py.hooks import hookimpl

@hookimpl
def mrta_register_agents():
    return {"%s": print}

class More:
    @hookimpl
    def mrta_register_behaviours(self):
        return {"%s": print}

more = More()
"""


@pytest.fixture(autouse=True)
def _imports() -> Iterator[None]:
    """Leave neither modules nor folders behind."""
    modules, path = set(sys.modules), list(sys.path)
    yield
    sys.path[:] = path
    for name in set(sys.modules) - modules:
        del sys.modules[name]


@pytest.fixture
def plugin(tmp_path: Path) -> Callable[..., Registration]:
    """Write a package with a plugin module and register it, without importing anything."""

    def make(package: str, text: str, module: str = "plugin") -> Registration:
        folder = tmp_path / package
        source = folder / "src" / package
        source.mkdir(parents=True, exist_ok=True)
        (source / "__init__.py").write_text("", encoding="utf-8")
        (source / "plugin.py").write_text(text, encoding="utf-8")
        manifest = folder / "package.xml"
        return Registration(
            package, folder, RegistrationKind.PLUGIN, plugin=f"{package}.{module}", manifest=manifest, line=7
        )

    return make


def test_load_plugins_imports_in_order_from_the_packages_source_folders(plugin: Callable[..., Registration]) -> None:
    manager = PluginManager()
    registrations = [plugin("yard_b", GOOD % ("b", "b")), plugin("yard_a", GOOD % ("a", "a"))]

    problems = load_plugins(registrations, manager)

    assert problems == ()
    assert manager.names == ("yard_b.plugin", "yard_a.plugin")
    assert list(manager.registered("mrta_register_agents")) == ["b", "a"]
    assert sys.path[-2:] == [str(entry.folder / "src") for entry in registrations]


def test_a_plugin_imports_the_package_of_one_that_comes_later(plugin: Callable[..., Registration]) -> None:
    borrowing = plugin("yard_p", "from yard_q.plugin import more\nfrom yard_r.plugin import mrta_register_agents")
    lenders = [plugin(name, GOOD % (name, name)) for name in ("yard_q", "yard_r")]
    manager = PluginManager()

    assert load_plugins([borrowing, *lenders], manager) == ()

    assert list(manager.registered("mrta_register_agents")) == ["yard_r", "yard_q"]


def test_load_plugin_appends_the_source_folder_once(plugin: Callable[..., Registration]) -> None:
    registration = plugin("yard_c", GOOD % ("c", "c"))
    load_plugin(registration, PluginManager())
    load_plugin(registration, PluginManager())

    assert sys.path.count(str(registration.folder / "src")) == 1


def test_load_plugin_that_can_be_imported_leaves_the_path_alone(
    plugin: Callable[..., Registration], monkeypatch: pytest.MonkeyPatch
) -> None:
    registration = plugin("yard_d", GOOD % ("d", "d"))
    monkeypatch.syspath_prepend(str(registration.folder / "src"))
    before = list(sys.path)

    load_plugin(registration, PluginManager())

    assert sys.path == before


def test_load_plugin_takes_an_object_of_a_module(plugin: Callable[..., Registration]) -> None:
    manager = PluginManager()

    load_plugin(plugin("yard_e", GOOD % ("e", "e"), "plugin:more"), manager)

    assert manager.registered("mrta_register_agents") == {}
    assert list(manager.registered("mrta_register_behaviours")) == ["e"]


def test_load_plugins_counts_a_plugin_registered_twice_once(plugin: Callable[..., Registration]) -> None:
    manager = PluginManager()
    registration = plugin("yard_f", GOOD % ("f", "f"))

    assert load_plugins([registration, registration], manager) == ()
    assert manager.names == ("yard_f.plugin",)


@pytest.mark.parametrize(
    ("package", "text", "message"),
    [
        ("yard_g", "import no_such_module", "ModuleNotFoundError: No module named 'no_such_module'"),
        ("yard_h", "1 / 0", "ZeroDivisionError: division by zero"),
        ("yard_i", "raise SystemExit(3)", "SystemExit: 3"),
        ("yard_j", "def :", "SyntaxError: invalid syntax (plugin.py, line 1)"),
    ],
)
def test_load_plugins_reports_a_plugin_that_cannot_be_imported_and_goes_on(
    plugin: Callable[..., Registration], package: str, text: str, message: str
) -> None:
    manager = PluginManager()
    broken = plugin(package, text)

    (problem,) = load_plugins([broken, plugin("yard_k", GOOD % ("k", "k"))], manager)

    assert str(problem) == (
        f"{broken.manifest}:7: package {package!r}: plugin '{package}.plugin' cannot be imported: {message}"
    )
    assert manager.names == ("yard_k.plugin",)
    with pytest.raises(HookError) as caught:
        load_plugin(broken, manager)
    assert caught.value.__cause__ is not None


def test_load_plugins_refuses_a_plugin_that_breaks_the_contract(plugin: Callable[..., Registration]) -> None:
    text = "from rqt_mrta_py.hooks import hookimpl\n@hookimpl\ndef mrta_on_evnt(event): pass\n"

    with pytest.raises(
        HookError, match=r"plugin 'yard_l\.plugin': mrta_on_evnt\(event\) implements mrta_on_evnt, which"
    ):
        load_plugins([plugin("yard_l", text)], PluginManager())


def test_load_plugins_passes_over_what_is_no_plugin(tmp_path: Path) -> None:
    registration = Registration("p", tmp_path, RegistrationKind.APPLICATION, file=tmp_path / "rqt_mrta.xml")

    assert load_plugins([registration], PluginManager()) == ()
