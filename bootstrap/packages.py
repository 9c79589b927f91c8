"""Python packages in ``.venv``: the checkout, editable, with its extras; then one import of everything compiled.

With the system's packages in sight pip is content with a system matplotlib, say, that was compiled for an older
numpy than the one that another package just brought. Only an import tells, hence the probe.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Dict, List

from bootstrap import environment, shell

EXTRAS = {"run": "all", "test": "all,test"}

# Compiled modules and the distributions that bring them, numpy before those that build on it.
COMPILED = {
    "numpy": "numpy",
    "yaml": "PyYAML",
    "lxml.etree": "lxml",
    "lz4.frame": "lz4",
    "rosbags.rosbag1": "rosbags",
    "scipy.optimize": "scipy",
    "scipy.spatial": "scipy",
    "cv2": "opencv-python-headless",
    "PIL.ImageFont": "pillow",
    "PIL._imagingft": "pillow",
    "matplotlib.figure": "matplotlib",
    "matplotlib.backends.backend_agg": "matplotlib",
    "pybullet": "pybullet",
}

_PIP = ("-m", "pip", "install", "-qq", "--no-input")


def provide(checkout: Path, level: str) -> None:
    """Install what setup.py declares for a level, and mend what does not import.

    Args:
        checkout: Its root folder.
        level: ``run`` or ``test``.

    Raises:
        SetupError: pip failed, or something does not import even from a fresh copy.
    """
    shell.say("installing Python packages; the first time this takes a minute or two")
    _pip(checkout, ["--editable", f".[{EXTRAS[level]}]"])
    # rosrun looks for a program anywhere below its package, and would ask which one is meant: this or scripts/mrta.
    environment.python_of(checkout).with_name("mrta").unlink(missing_ok=True)
    mended: List[str] = []
    while True:
        _put_own_toolkits_first(checkout)
        failures = failing_imports(checkout)
        if not failures:
            return
        unfit = sorted({COMPILED[module] for module in failures})
        if set(unfit) <= set(mended):
            detail = "".join(f"\n    {module}: {error}" for module, error in failures.items())
            raise shell.SetupError(f"installed, but not to be imported:{detail}")
        shell.say(f"the system's {', '.join(unfit)} does not fit; installing it afresh")
        requirements = declared_requirements(checkout)
        _pip(checkout, ["--ignore-installed", *(requirements[name.lower()] for name in unfit)])
        mended += unfit


def failing_imports(checkout: Path) -> Dict[str, str]:
    """Import every compiled dependency in one new process of the environment.

    Args:
        checkout: Its root folder.

    Returns:
        What went wrong, by module; empty when all fit together.
    """
    probe = Path(__file__).with_name("probe.py")
    answer = shell.run([str(environment.python_of(checkout)), "-I", "-B", str(probe), *COMPILED])
    failures: Dict[str, str] = {}
    begun = None
    for line in answer.stdout.splitlines():
        verb, _, rest = line.partition(" ")
        module, _, error = rest.partition(" ")
        if verb == "begin":
            begun = module
        elif verb == "failed":
            failures[module] = error
    if answer.returncode and begun is not None:
        failures[begun] = f"the interpreter ended with {answer.returncode}"
    elif answer.returncode:
        raise shell.SetupError(f"the environment's Python does not start{shell.tail(answer)}")
    return failures


def declared_requirements(checkout: Path) -> Dict[str, str]:
    """Read the checkout's requirements, extras included, from its installed metadata.

    Args:
        checkout: Its root folder.

    Returns:
        Requirement with its bounds, by lower-case name.
    """
    question = "from importlib.metadata import requires; print(*requires('rqt_mrta_py'), sep='\\n')"
    answer = shell.run([str(environment.python_of(checkout)), "-I", "-c", question])
    declared = (line.partition(";")[0].strip() for line in answer.stdout.splitlines())
    return {re.split(r"[^A-Za-z0-9._-]", requirement, maxsplit=1)[0].lower(): requirement for requirement in declared}


def _put_own_toolkits_first(checkout: Path) -> None:
    # Debian's matplotlib claims the namespace mpl_toolkits for itself when Python starts, by a .pth file. Ours is read
    # before it, and an import made early stays first.
    site = environment.site_packages(checkout)
    if (site / "mpl_toolkits").is_dir():
        (site / "mrta_mpl_toolkits.pth").write_text("import mpl_toolkits\n", encoding="utf-8")


def _pip(checkout: Path, arguments: List[str]) -> None:
    mark = environment.mark(checkout)
    mark.touch()
    process = shell.run([str(environment.python_of(checkout)), *_PIP, *arguments], folder=checkout)
    # pip that ends of its own accord leaves whole packages; one that was killed may not.
    if process.returncode >= 0:
        mark.unlink()
    if process.returncode:
        raise shell.SetupError(
            f"pip could not install {arguments[-1]}; is there a way to a package index?{shell.tail(process)}"
        )
