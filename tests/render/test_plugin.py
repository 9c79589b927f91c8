from __future__ import annotations

import pluggy

from rqt_mrta_py.hooks import PROJECT, HookSpecs
from rqt_mrta_py.render import MonitorRenderer, draw_dashboard, plugin


def test_hook_mrta_register_renderers_names_monitor_and_dashboard() -> None:
    manager = pluggy.PluginManager(PROJECT)
    manager.add_hookspecs(HookSpecs)
    manager.register(plugin)
    manager.check_pending()
    (renderers,) = manager.hook.mrta_register_renderers()
    assert sorted(renderers) == ["dashboard", "monitor"]
    assert renderers["dashboard"] is draw_dashboard
    assert isinstance(renderers["monitor"], MonitorRenderer)
