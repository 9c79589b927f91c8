"""What plugins implement, told without importing them."""

from __future__ import annotations

import sys
import textwrap
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from rqt_mrta_py.hooks import PluginManager
from rqt_mrta_py.hooks.contract import HOOKS
from rqt_mrta_py.hooks.survey import hooks_in, implemented_hooks, plugin_source

SOURCES = {
    "functions of the module": (
        """
        from rqt_mrta_py.hooks import hookimpl
        @hookimpl
        def mrta_on_event(event): pass
        @hookimpl
        def mrta_register_agents(): return {}
        def helper(): pass
        """,
        "",
        ["mrta_register_agents", "mrta_on_event"],
    ),
    "a marker under another name, or in its module": (
        """
        import rqt_mrta_py.hooks
        from rqt_mrta_py.hooks import hookimpl as mark
        @mark
        def mrta_on_event(event): pass
        @rqt_mrta_py.hooks.hookimpl
        def mrta_register_agents(): return {}
        """,
        "",
        ["mrta_register_agents", "mrta_on_event"],
    ),
    "a hook named by an option": (
        """
        from rqt_mrta_py.hooks import hookimpl
        @hookimpl(specname="mrta_on_event")
        def tell(event): pass
        """,
        "",
        ["mrta_on_event"],
    ),
    "a function marked afterwards": (
        """
        from rqt_mrta_py.hooks import hookimpl
        mrta_on_event = hookimpl(lambda event: None)
        """,
        "",
        ["mrta_on_event"],
    ),
    "functions under a condition": (
        """
        from rqt_mrta_py.hooks import hookimpl
        try:
            import nothing_of_this_name
        except ImportError:
            @hookimpl
            def mrta_on_event(event): pass
        else:
            pass
        if True:
            with open("/dev/null"):
                @hookimpl
                def mrta_register_worlds(): return {}
        """,
        "",
        ["mrta_register_worlds", "mrta_on_event"],
    ),
    "methods are the class's, not the module's": (
        """
        from rqt_mrta_py.hooks import hookimpl
        class Plugin:
            @hookimpl
            def mrta_on_event(self, event): pass
        """,
        "",
        [],
    ),
    "an object made from a class that is derived from another": (
        """
        from rqt_mrta_py.hooks import hookimpl
        class Base:
            @hookimpl
            def mrta_on_event(self, event): pass
        class Plugin(Base):
            @hookimpl
            def mrta_register_worlds(self): return {}
        @hookimpl
        def mrta_register_agents(): return {}
        plugin = Plugin()
        """,
        "plugin",
        ["mrta_register_worlds", "mrta_on_event"],
    ),
}


@pytest.mark.parametrize(("source", "attribute", "hooks"), list(SOURCES.values()), ids=list(SOURCES))
def test_reading_finds_what_loading_would_find(source: str, attribute: str, hooks: Any) -> None:
    text = textwrap.dedent(source)
    assert list(hooks_in(text, attribute)) == hooks

    module = ModuleType("surveyed")
    exec(text, vars(module))
    manager = PluginManager()
    manager.register(getattr(module, attribute) if attribute else module, "surveyed")
    assert [hook for hook in HOOKS if manager.implementers(hook)] == hooks


def test_a_hook_that_a_module_imports_counts() -> None:
    assert hooks_in("from mine.parts import mrta_on_event, helper") == ("mrta_on_event",)


def test_what_is_not_marked_or_no_hook_does_not_count() -> None:
    assert hooks_in("def mrta_on_event(event): pass\n@hookimpl\ndef mrta_on_evnt(event): pass\n") == ()


PLUGIN = "from rqt_mrta_py.hooks import hookimpl\n@hookimpl\ndef mrta_on_event(event): pass\n"


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """Make a package whose Python code says so loudly if it is run."""
    source = tmp_path / "surveyed_package" / "src" / "surveyed_package"
    source.mkdir(parents=True)
    (source / "__init__.py").write_text("raise RuntimeError('imported')\n")
    (source / "plugin.py").write_text("raise RuntimeError('imported')\n" + PLUGIN)
    return source.parent.parent


def test_a_plugin_is_found_in_its_packages_source_folder_and_not_imported(package: Path) -> None:
    assert implemented_hooks("surveyed_package.plugin", package) == ("mrta_on_event",)
    assert "surveyed_package" not in sys.modules


def test_what_is_on_the_path_comes_before_the_packages_source_folder(
    package: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    installed = tmp_path / "installed" / "surveyed_package"
    installed.mkdir(parents=True)
    (installed / "__init__.py").write_text("")
    (installed / "plugin.py").write_text("")
    monkeypatch.syspath_prepend(str(installed.parent))

    assert plugin_source("surveyed_package.plugin", package) == installed / "plugin.py"


@pytest.mark.parametrize("module", ["surveyed_package.missing", "nothing_of_this_name.plugin", "sys", "", "."])
def test_a_module_without_source_is_unknown(package: Path, module: str) -> None:
    assert implemented_hooks(module, package) is None


@pytest.mark.parametrize("source", [b"def :", b"\x00", b"\xff\xfe"])
def test_a_source_that_is_no_python_is_unknown(package: Path, source: bytes) -> None:
    (package / "src" / "surveyed_package" / "plugin.py").write_bytes(source)

    assert implemented_hooks("surveyed_package.plugin", package) is None
