"""Edit an application, and write its parameter files and launch files."""

from __future__ import annotations

import argparse
import difflib
import os
import re
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, List, Optional, Tuple

from rqt_mrta_py.app.cli.common import complain_about, print_json
from rqt_mrta_py.app.cli.stdout import standard_output

if TYPE_CHECKING:
    from rqt_mrta_py.config.editing.configuring import Configuration

__all__ = ["add_arguments", "main"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Say what the verb takes."""
    parser.add_argument(
        "application", metavar="APPLICATION", help="a registered name, or the path of a package or rqt_mrta.xml"
    )
    parser.add_argument("--architecture", metavar="A", help="whose parameters (default: the application's own)")
    edits = parser.add_argument_group("edits", "made in the order given, all of them or none")

    def option(name: str, metavar: str, make: Callable[[str, str], Any], text: str) -> None:
        edits.add_argument(name, metavar=metavar, action=_Edit, make=make, dest="edits", default=[], help=text)

    option("--set", "PATH=VALUE", _set, "give a parameter a value, for instance robot2/spin_rate=10")
    option("--unset", "PATH", _unset, "take a parameter, or a group, back to its default")
    option("--add-robot", "ID[:TASKS]", _add_robot, "let a robot join; its tasks are joined by commas (default: all)")
    option("--remove-robot", "ID", _remove_robot, "let a robot leave")
    option("--rename-robot", "OLD=NEW", _rename_robot, "give a robot another id, wherever it stands")
    option("--add-task", "ID[:ROBOTS]", _add_task, "add a task; its robots are joined by commas (default: all)")
    option("--kind", "KIND", _kind, "of the task added before: the behaviour that carries it out")
    option("--place", "X,Y[,YAW]", _place, "of the task added before [m, m, rad]")
    option("--remove-task", "ID", _remove_task, "take a task out")
    option("--rename-task", "OLD=NEW", _rename_task, "give a task another id, wherever it stands")
    parser.add_argument("--dry-run", action="store_true", help="write nothing; show what would change, as a diff")
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 if anything would change")
    parser.add_argument("--json", action="store_true", help="print what is done as JSON")


def main(options: argparse.Namespace) -> int:
    """Edit and write, or say what would be written."""
    from rqt_mrta_py.app.compose import compose
    from rqt_mrta_py.config.editing.configuring import plan_configuration

    host = compose()
    complain_about(host.problems)
    plan = plan_configuration(host.registry, options.application, options.architecture, options.edits, host.manager)
    writes = not (options.dry_run or options.check)
    if writes:
        plan.carry_out()
    with standard_output():
        if options.json:
            print_json("configure", _described(plan, writes))
        elif options.dry_run:
            _print_diff(plan)
        else:
            _print_actions(plan, writes)
    return 1 if options.check and plan.changes else 0


def _described(plan: Configuration, writes: bool) -> Any:
    files = [{"path": str(each.path), "action": each.action} for each in plan.files]
    left = [{"path": str(path), "action": "left"} for path in plan.left]
    return {
        "application": plan.application,
        "folder": str(plan.folder),
        "written": writes,
        "files": sorted([*files, *left], key=lambda each: each["path"]),
    }


def _print_actions(plan: Configuration, writes: bool) -> None:
    for each in plan.changes:
        print(f"{each.action if writes else f'would be {each.action}'}: {_shown(each.path)}")
    for path in plan.left:
        print(f"left: {_shown(path)}: it was not generated")
    if not plan.changes:
        print("nothing to change")


def _print_diff(plan: Configuration) -> None:
    from rqt_mrta_py.config.editing.telling import MANY_LINES

    for each in plan.changes:
        name = _shown(each.path)
        before, after = ((text or "").splitlines() for text in (each.before, each.after))
        print(f"--- {'/dev/null' if each.before is None else name}")
        print(f"+++ {'/dev/null' if each.after is None else name}")
        # As difflib.unified_diff, which takes lines that stand often, as those of parameters do, for noise.
        matcher = difflib.SequenceMatcher(None, before, after, autojunk=len(before) > MANY_LINES)
        for group in matcher.get_grouped_opcodes(3):
            _, first, _, third, _ = group[0]
            _, _, second, _, fourth = group[-1]
            print(f"@@ -{_range(first, second)} +{_range(third, fourth)} @@")
            for tag, old, old_end, new, new_end in group:
                if tag == "equal":
                    print(*(f" {line}" for line in before[old:old_end]), sep="\n")
                    continue
                for line in before[old:old_end]:
                    print(f"-{line}")
                for line in after[new:new_end]:
                    print(f"+{line}")


def _range(start: int, stop: int) -> str:
    """Write a range of lines as patch reads it: an empty one is named by the line before it."""
    length = stop - start
    return f"{start + 1 if length else start},{length}"


def _shown(path: Path) -> str:
    """Name a file from the current folder, where that is shorter."""
    return min(str(path), os.path.relpath(str(path)), key=len)


class _Edit(argparse.Action):
    """Adds an edit to one list, so that edits of all kinds keep their order."""

    def __init__(self, make: Callable[[str, str], Any], **options: Any) -> None:
        super().__init__(**options)
        self._make = make

    def __call__(
        self, parser: argparse.ArgumentParser, namespace: argparse.Namespace, values: Any, option: Optional[str] = None
    ) -> None:
        edits = list(getattr(namespace, self.dest))
        try:
            made = self._make(str(values), option or "")
            if isinstance(made, dict):
                from rqt_mrta_py.config.editing.tasks import AddTask

                if not edits or not isinstance(edits[-1], AddTask):
                    raise ValueError("must follow the --add-task that it belongs to")
                edits[-1] = replace(edits[-1], **made)
            else:
                edits.append(made)
        except ValueError as error:
            raise argparse.ArgumentError(self, str(error)) from error
        setattr(namespace, self.dest, edits)


def _set(text: str, _option: str) -> Any:
    from rqt_mrta_py.config.editing.values import SetValue

    path, value = _pair(text, "PATH=VALUE")
    return SetValue(path, value)


def _unset(text: str, _option: str) -> Any:
    from rqt_mrta_py.config.editing.values import UnsetValue

    return UnsetValue(text)


def _add_robot(text: str, _option: str) -> Any:
    from rqt_mrta_py.config.editing.robots import AddRobot

    name, tasks = _with_names(text)
    return AddRobot(name, tasks)


def _remove_robot(text: str, _option: str) -> Any:
    from rqt_mrta_py.config.editing.robots import RemoveRobot

    return RemoveRobot(_id(text))


def _rename_robot(text: str, _option: str) -> Any:
    from rqt_mrta_py.config.editing.robots import RenameRobot

    old, new = _pair(text, "OLD=NEW")
    return RenameRobot(_id(old), _id(new))


def _add_task(text: str, _option: str) -> Any:
    from rqt_mrta_py.config.editing.tasks import AddTask

    name, robots = _with_names(text)
    return AddTask(name, robots)


def _kind(text: str, _option: str) -> Any:
    return {"kind": text}


def _place(text: str, _option: str) -> Any:
    numbers = text.split(",")
    if len(numbers) not in (2, 3) or not all(re.match(r"\s*[-+]?[0-9]*\.?[0-9]+\s*\Z", number) for number in numbers):
        raise ValueError(f"{text!r}: X,Y or X,Y,YAW is expected, such as 1.5,-2")
    return {"place": tuple(float(number) for number in numbers)}


def _remove_task(text: str, _option: str) -> Any:
    from rqt_mrta_py.config.editing.tasks import RemoveTask

    return RemoveTask(_id(text))


def _rename_task(text: str, _option: str) -> Any:
    from rqt_mrta_py.config.editing.tasks import RenameTask

    old, new = _pair(text, "OLD=NEW")
    return RenameTask(_id(old), _id(new))


def _pair(text: str, form: str) -> Tuple[str, str]:
    left, equals, right = (part.strip() for part in text.partition("="))
    if not equals or not left:
        raise ValueError(f"{text!r}: {form} is expected")
    return left, right


def _with_names(text: str) -> Tuple[str, Tuple[str, ...]]:
    name, colon, rest = text.partition(":")
    names: List[str] = [_id(part) for part in rest.split(",")] if colon else []
    if not all(names):
        raise ValueError(f"{text!r}: names joined by commas are expected behind the colon")
    return _id(name), tuple(names)


def _id(text: str) -> str:
    from rqt_mrta_py.model import normalise_id

    return normalise_id(text.strip())
