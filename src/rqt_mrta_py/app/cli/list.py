"""List the architectures, applications, plugins and hooks that are registered, and where."""

from __future__ import annotations

import argparse
import os
import sys
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Sequence, Tuple

from rqt_mrta_py.app.cli.common import complain_about, print_json, print_table
from rqt_mrta_py.app.cli.stdout import standard_output

if TYPE_CHECKING:
    from rqt_mrta_py.app.catalogue.entries import Entry
    from rqt_mrta_py.app.catalogue.plugins import PluginEntry

__all__ = ["add_arguments", "main"]

_KINDS = ("architectures", "applications", "plugins", "hooks")
_UNASKED = _KINDS[:3]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument("kind", nargs="?", choices=_KINDS, help="only these; hooks: who implements each")
    parser.add_argument(
        "--type",
        metavar="ST-SR-IA",
        default="",
        help="only what fits this taxonomy; an axis left blank or * matches any (--type=-SR-)",
    )
    parser.add_argument("--json", action="store_true", help="print as JSON")


def main(options: argparse.Namespace) -> int:
    """Print the list."""
    from rqt_mrta_py.app.catalogue.entries import entries
    from rqt_mrta_py.app.catalogue.plugins import hook_entries, plugin_entries
    from rqt_mrta_py.app.catalogue.taxonomy_filter import parse_filter
    from rqt_mrta_py.app.loading.blocking import warn_of_blocking
    from rqt_mrta_py.app.loading.environment import plugin_settings
    from rqt_mrta_py.app.loading.registry import registry_only
    from rqt_mrta_py.config.discovery.registration import RegistrationKind
    from rqt_mrta_py.model import Taxonomy

    wanted = parse_filter(options.type)
    blocked = plugin_settings(os.environ).blocked
    registry = registry_only()
    kinds = _UNASKED if options.kind is None else (options.kind,)
    listed: Dict[str, List[Entry]] = {
        kind: entries(registry, RegistrationKind(kind[:-1]), wanted)
        for kind in kinds
        if kind in ("architectures", "applications")
    }
    # Plugins have no taxonomy: they fit only the blank.
    plugins = plugin_entries(registry, blocked) if wanted == Taxonomy() else []
    complain_about(
        [
            *registry.problems,
            *(problem for found in listed.values() for entry in found for problem in entry.problems),
        ]
    )
    warn_of_blocking(registry, blocked)
    if not registry.registrations:
        print(
            "mrta: no package registers anything; put the folder of those that do on ROS_PACKAGE_PATH", file=sys.stderr
        )
    with standard_output():
        if options.json:
            document: Dict[str, Any] = {kind: [_as_json(entry) for entry in found] for kind, found in listed.items()}
            if "plugins" in kinds:
                document["plugins"] = _plugins_as_json(plugins)
            if "hooks" in kinds:
                document["hooks"] = [{"name": h, "implemented_by": who} for h, who in hook_entries(plugins).items()]
            print_json("list", document)
        elif options.kind == "plugins":
            _print_plugins(plugins)
        elif options.kind == "hooks":
            print_table(
                ("KIND", "NAME", "IMPLEMENTED BY"),
                [("hook", hook, ", ".join(who)) for hook, who in hook_entries(plugins).items()],
            )
        else:
            _print(listed, plugins if "plugins" in kinds else ())
    return 0


def _print(listed: Dict[str, List[Entry]], plugins: Sequence[PluginEntry]) -> None:
    rows: List[Tuple[str, ...]] = [
        (
            kind[:-1],
            entry.registration.package,
            str(entry.taxonomy or ""),
            _about(entry),
            str(entry.registration.folder),
        )
        for kind, found in listed.items()
        for entry in found
    ]
    rows += [("plugin", entry.package, "", _plugin_name(entry), str(entry.folder)) for entry in plugins]
    print_table(("KIND", "NAME", "TYPE", "ABOUT", "FOLDER"), rows)


def _print_plugins(plugins: Sequence[PluginEntry]) -> None:
    from rqt_mrta_py.app.catalogue.plugins import surveyed

    hooks = surveyed(plugins)
    rows = [(_plugin_name(entry), entry.package, _told(hooks[entry.plugin])) for entry in plugins]
    print_table(("PLUGIN", "PACKAGE", "HOOKS"), rows)


def _told(hooks: Optional[Sequence[str]]) -> str:
    return "unknown: no source found" if hooks is None else ", ".join(hooks)


def _plugin_name(entry: PluginEntry) -> str:
    return f"{entry.plugin} (blocked)" if entry.blocked else entry.plugin


def _about(entry: Entry) -> str:
    if entry.problems:
        count = len(entry.problems)
        return f"! cannot be used: {count} problem{'s' if count > 1 else ''}, told above"
    return f"{entry.title} ({entry.architecture})" if entry.architecture else entry.title


def _as_json(entry: Entry) -> Dict[str, Any]:
    registration = entry.registration
    return {
        "name": registration.package,
        "title": entry.title or None,
        "taxonomy": str(entry.taxonomy) if entry.taxonomy else None,
        "architecture": entry.architecture,
        "module": None,
        "file": str(registration.file) if registration.file else None,
        "folder": str(registration.folder),
        "problems": [str(problem) for problem in entry.problems],
    }


def _plugins_as_json(plugins: Sequence[PluginEntry]) -> List[Dict[str, Any]]:
    from rqt_mrta_py.app.catalogue.plugins import surveyed

    hooks = surveyed(plugins)
    return [
        {
            "name": entry.package,
            "title": None,
            "taxonomy": None,
            "architecture": None,
            "module": entry.plugin,
            "file": None,
            "folder": str(entry.folder),
            "problems": [],
            "hooks": hooks[entry.plugin],
            "blocked": entry.blocked,
        }
        for entry in plugins
    ]
