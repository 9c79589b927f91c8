"""Every hook of a plugin that raises, returns another type or takes for ever: named, and stopped or isolated."""

from __future__ import annotations

from pathlib import Path

import pytest

from rqt_mrta_py.hooks.contract import HOOKS
from tests.app.outputs import Mrta

REGISTERS = [hook for hook in HOOKS if hook.startswith("mrta_register_")]
COMMANDS = {
    "mrta_register_assembly_planners": ["plan-structure", "wall", "--method", "exact"],
    "mrta_register_verbs": ["any"],
    "mrta_register_benchmarks": ["bench"],
}
RUN = [
    *("run", "border_patrol", "--duration", "1", "--processes", "1", "--pictures", "0.5"),
    *("--export", "csv", "--figures", "alliance"),
]


def implementation(hook: str, body: str) -> str:
    arguments = ", ".join(HOOKS[hook].parameters)
    return f"from rqt_mrta_py.hooks import hookimpl\n\n\n@hookimpl\ndef {hook}({arguments}):\n    {body}\n"


@pytest.mark.parametrize("hook", [*REGISTERS, "mrta_check_parameters"])
@pytest.mark.parametrize(
    ("body", "complaint"),
    [("raise RuntimeError('no')", "raised RuntimeError: no"), ("return 5", "returned 5; a ")],
    ids=["raises", "returns another type"],
)
def test_a_hook_whose_answer_is_needed_stops_the_command_by_name(
    mrta: Mrta, stranger: Path, hook: str, body: str, complaint: str
) -> None:
    command = COMMANDS.get(hook, RUN)
    if hook == "mrta_register_grounds_readers":
        # Asked where a recorded mission is to be explained.
        assert mrta("run", "border_patrol", "--duration", "1", "--pictures", "0", "--out", "r")[0] == 0
        command = ["review", "r/mission.bag", "--why", "wander", "--pictures", "0"]
    stranger.write_text(implementation(hook, body))

    status, lines = mrta(*command)

    assert (status, len(lines)) == (3, 1)
    assert lines[0].startswith(f"mrta: plugin 'stranger_plugin': {hook} {complaint}")


@pytest.mark.parametrize("hook", ["mrta_register_agents", "mrta_check_parameters", *COMMANDS])
def test_a_hook_that_takes_for_ever_stops_the_command_with_its_place(
    mrta: Mrta, stranger: Path, monkeypatch: pytest.MonkeyPatch, hook: str
) -> None:
    monkeypatch.setenv("RQT_MRTA_PY_PATIENCE", "1")
    stranger.write_text(implementation(hook, "while True: pass"))

    status, lines = mrta(*COMMANDS.get(hook, RUN))

    assert (status, lines) == (
        3,
        [
            f"mrta: plugin 'stranger_plugin': {hook}: no answer within 1 s; interrupted in {hook} ({stranger}:6); "
            "RQT_MRTA_PY_PATIENCE sets another limit [s], 0 for none"
        ],
    )


@pytest.mark.parametrize("hook", ["mrta_on_mission_start", "mrta_on_event", "mrta_on_mission_end"])
def test_an_observer_that_takes_for_ever_is_named_and_the_run_goes_on(
    mrta: Mrta, stranger: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture, hook: str
) -> None:
    monkeypatch.setenv("RQT_MRTA_PY_PATIENCE", "1")
    stranger.write_text(implementation(hook, "while True: pass"))

    status, _ = mrta("run", "border_patrol", "--duration", "1", "--processes", "1", "--pictures", "0")

    assert status == 0
    (message,) = [each for each in caplog.messages if "stranger" in each]
    assert message.startswith(f"event=observer_dismissed plugin=stranger_plugin hook={hook}: ")
