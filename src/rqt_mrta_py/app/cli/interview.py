"""The questions of ``mrta new`` on a terminal, as rqt_mrta's wizards asked them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Optional, Sequence

from rqt_mrta_py.app.cli.new_flags import robots_of_text, tasks_of_text
from rqt_mrta_py.app.cli.prompts import ask
from rqt_mrta_py.config.packages.answers import Answer, Answers
from rqt_mrta_py.config.packages.answers_form import ANSWERS
from rqt_mrta_py.config.packages.checks import Surroundings, must_be_asked, wrong_with
from rqt_mrta_py.config.packages.entries import ValueEntry
from rqt_mrta_py.config.packages.origin import Origin
from rqt_mrta_py.config.parameters.values import parse_text
from rqt_mrta_py.errors import ConfigError
from rqt_mrta_py.wording import accepted

if TYPE_CHECKING:
    from rqt_mrta_py.config.packages.mandatory import MissingValue
    from rqt_mrta_py.config.yaml.schema import Key

__all__ = ["ask_for_missing", "ask_for_values"]

_TYPED = Origin("answer")
_ASKED = ("workspace", "name", "version", "license", "run_depends")
"""What is asked besides that which has no default."""


def ask_for_missing(answers: Answers, surroundings: Callable[[Answers], Surroundings]) -> Answers:
    """Ask whatever is not answered, if anything is missing that has no default.

    Args:
        answers: so far.
        surroundings: tells what a package has to fit into, once its place is known.

    Raises:
        KeyboardInterrupt: whoever is asked leaves.
    """
    mandatory = must_be_asked(answers.kind)
    if all(key in answers for key in mandatory):
        return answers
    for key in ANSWERS[answers.kind].keys:
        if key.name in answers or key.name not in (*mandatory, *_ASKED):
            continue
        around = surroundings(answers)
        default = _default(key, answers)
        text = ask(_tool_tip(key, around), key.name, default, _check(key.name, answers, around))
        if text:
            answers = answers.covered({key.name: Answer(_value(key.name, text), _TYPED)})
    return answers


def ask_for_values(answers: Answers, missing: Sequence[MissingValue]) -> Answers:
    """Ask for parameters that are mandatory.

    Raises:
        KeyboardInterrupt: whoever is asked leaves.
    """
    entries = list(answers.values)
    for value in missing:
        tip = value.template.tool_tip or "Enter the value; it is mandatory."
        text = ask(tip, value.path, "", lambda text, each=value: _wrong_with_value(each, text))  # type: ignore[misc]
        entries.append(ValueEntry(value.path, text, _TYPED))
    return answers.covered({"parameters": Answer(tuple(entries), _TYPED)})


def _wrong_with_value(value: MissingValue, text: str) -> Optional[str]:
    if not text or not text.isprintable():
        return f"The {value.path} parameter value must be given, because it is mandatory."
    try:
        parse_text(text, value.template.type)
    except ValueError as error:
        return str(error)
    return None


def _tool_tip(key: Key, around: Surroundings) -> str:
    if key.name == "architecture":
        return f"{key.summary} There are: {', '.join(around.architectures) or 'none'}."
    if key.name == "tasks":
        return f"{key.summary} Kinds: {', '.join(around.kinds) or 'none'}."
    return key.summary


def _default(key: Key, answers: Answers) -> str:
    if key.name == "name":
        words = answers.text("package").replace("_", " ").strip()
        return words[:1].upper() + words[1:]
    return key.default if isinstance(key.default, str) else ""


def _value(key: str, text: str) -> Any:
    if key == "robots":
        return robots_of_text(text, _TYPED)
    if key == "tasks":
        return tasks_of_text(text, _TYPED)
    if key == "run_depends":
        return tuple(text.replace(",", " ").split())
    return text


def _check(key: str, answers: Answers, around: Surroundings) -> Callable[[str], Optional[str]]:
    from rqt_mrta_py.config.packages.checks import find_problems

    def wrong(text: str) -> Optional[str]:
        if not text.isprintable():
            return f"must be a text of one line (got {text!r})"
        try:
            value = _value(key, text)
        except ConfigError as error:
            return error.problems[0].message
        message = wrong_with(key, value, around)
        if message is not None:
            return message
        if key == "workspace":
            return _wrong_with_workspace(text)
        if key == "run_depends":
            strange = [name for name in value if name not in around.packages]
            return f"{strange[0]!r} is no ROS package; {accepted(strange[0], around.packages)}" if strange else None
        if key not in ("robots", "tasks"):
            return None
        # Ids are looked at among all robots and tasks; what else is not answered yet is not asked about here.
        covered = answers.covered({key: Answer(value, _TYPED)})
        found = [each for each in find_problems(covered, around) if each.path == _TYPED.path]
        return found[0].message if found else None

    return wrong


def _wrong_with_workspace(text: str) -> Optional[str]:
    return f"{text} is not a folder." if text and Path(text).exists() and not Path(text).is_dir() else None
