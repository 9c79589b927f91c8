from __future__ import annotations

import builtins
import subprocess
import sys

import pytest

from rqt_mrta_py.errors import MissingDependencyError
from rqt_mrta_py.sim.bullet.engine import Engine, load_pybullet

LOAD = "from rqt_mrta_py.sim.bullet.engine import load_pybullet; "


def test_load_pybullet_says_nothing_on_stdout_or_stderr():
    command = [sys.executable, "-c", LOAD + "load_pybullet().connect(2)"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert (done.stdout, done.stderr) == ("", "")


def test_load_pybullet_keeps_what_was_printed_before_and_after():
    command = [sys.executable, "-c", LOAD + "print('before'); load_pybullet(); print('after')"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout == "before\nafter\n"


def test_load_pybullet_says_what_to_install_when_it_is_missing(monkeypatch):
    real_import = builtins.__import__

    def without_pybullet(name, *args, **kwargs):
        if name == "pybullet":
            raise ImportError("No module named 'pybullet'")
        return real_import(name, *args, **kwargs)

    monkeypatch.delitem(sys.modules, "pybullet", raising=False)
    monkeypatch.setattr(builtins, "__import__", without_pybullet)
    with pytest.raises(MissingDependencyError) as caught:
        load_pybullet()
    assert str(caught.value) == (
        "world bullet: PyBullet cannot be imported (No module named 'pybullet'); "
        "install it with: pip install 'rqt_mrta_py[sim]'"
    )
    assert caught.value.exit_code == 4


def test_importing_the_room_and_its_plugin_imports_no_pybullet_and_no_numpy():
    program = (
        "import sys, rqt_mrta_py.sim, rqt_mrta_py.sim.plugin as p; p.mrta_register_worlds(); "
        "p.mrta_register_robot_models(); p.mrta_register_sensors(); "
        "print([name for name in ('pybullet', 'numpy') if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


def test_engine_sets_its_parameters_again_after_every_reset():
    engine = Engine()
    try:
        for _ in range(2):
            engine.reset(1 / 40)
            parameters = engine.bullet.getPhysicsEngineParameters(physicsClientId=engine.client)
            assert parameters["numSolverIterations"] == 25
            assert parameters["fixedTimeStep"] == pytest.approx(1 / 40)
            assert parameters["gravityAccelerationZ"] == pytest.approx(-9.81)
    finally:
        engine.close()


def test_engine_disconnects_once_however_often_it_is_closed():
    engine = Engine()
    client = engine.client
    engine.close()
    assert not engine.bullet.isConnected(physicsClientId=client)
    other = Engine()
    engine.close()
    assert other.bullet.isConnected(physicsClientId=other.client)
    other.close()
