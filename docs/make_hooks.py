"""Write docs/hooks.md from the hook specifications: ``python docs/make_hooks.py``."""

from __future__ import annotations

import inspect
from pathlib import Path
from typing import Callable, Dict, List

from rqt_mrta_py.app.catalogue.plugins import hook_entries, plugin_entries
from rqt_mrta_py.app.loading.environment import BLOCK, PATIENCE, TRACE
from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.hooks import HookSpecs

INTRODUCTION = """# Hooks

Everything that knows a particular architecture, task, world or picture is a plugin; the ones that come with this
package use the same hooks as yours. A plugin is a Python module named in a ROS package's manifest:

```xml
<exec_depend>rqt_mrta_py</exec_depend>
<export>
  <rqt_mrta_py plugin="my_package.plugin"/>
</export>
```

It imports `rqt_mrta_py.model` and `rqt_mrta_py.hooks`, nothing else of this project:

```python
from rqt_mrta_py.hooks import hookimpl


@hookimpl
def mrta_register_statistics():
    return {"incident_count": lambda record: len(record.incidents)}
```

An implementation may take fewer arguments than its specification, never others. `mrta list plugins` shows what is
found and which hooks it implements, `mrta list hooks` who implements each, both without importing anything of it.
"""

VARIABLES = f"""## Variables of the environment

* `{TRACE}=1` writes a line on stderr for each call of a hook: when [ms since the start], plugin, hook, how long it
  took [ms], what it returned in short.
* `{BLOCK}=a,b` leaves out the plugins of these packages or modules: they are neither imported nor registered. The
  project's own rooms cannot be left out.
* `{PATIENCE}=S` waits S seconds for an answer instead of a minute; 0 waits for ever.

Python code of the main thread is interrupted; code in C once it comes back to Python, and code that swallows every
exception again each second. Off the main thread nothing is interrupted.
"""


def render() -> str:
    """Render the page: introduction, the rules for all hooks, each hook with its signature and contract."""
    module = inspect.getmodule(HookSpecs)
    rules = inspect.cleandoc((module.__doc__ or "").split("\n", 1)[1]) if module else ""
    parts = [INTRODUCTION, "## Rules for all hooks\n", rules, "", VARIABLES]
    used = used_by()
    for name, function in sorted(vars(HookSpecs).items()):
        if name.startswith("mrta_"):
            parts += [f"## {name}\n", "```python", signature(name, function), "```\n", *contract(function)]
            parts[-1:] = [f"* **Used by**: {', '.join(used[name]) or 'nobody yet'}.", ""]
    return "\n".join(parts).rstrip() + "\n"


def used_by() -> Dict[str, List[str]]:
    """Find the plugins of this checkout by the hook that they implement, from their sources."""
    registry = discover({}, prefix="/nowhere", shares=(), distributions=())
    entries = hook_entries(plugin_entries(registry, ()))
    return {hook: [f"`{plugin}`" for plugin in sorted(plugins)] for hook, plugins in entries.items()}


def signature(name: str, function: Callable[..., object]) -> str:
    """Write a hook's signature as its plugin would."""
    given = inspect.signature(function)
    arguments = [str(argument) for argument in given.parameters.values() if argument.name != "self"]
    returns = given.return_annotation
    return f"def {name}({', '.join(arguments)}) -> {returns}".replace("'", "")


def contract(function: Callable[..., object]) -> List[str]:
    """Write a hook's docstring as a paragraph and a list."""
    summary, _, rest = inspect.cleandoc(function.__doc__ or "").partition("\n\n")
    lines: List[str] = []
    for line in rest.splitlines():
        head = line.partition(":")[0]
        if head in ("Called", "Args", "Returns", "Combined", "An exception"):
            lines.append(f"* **{head}**{line[len(head) :]}")
        else:
            lines.append(f"  {line}")
    return [summary, "", *lines, ""]


if __name__ == "__main__":
    (Path(__file__).parent / "hooks.md").write_text(render(), encoding="utf-8")
