from __future__ import annotations

import pluggy

from rqt_mrta_py.hooks import PROJECT, HookSpecs
from rqt_mrta_py.render import draw_dashboard, draw_monitor, plugin


def test_hook_mrta_register_renderers_names_monitor_and_dashboard() -> None:
    manager = pluggy.PluginManager(PROJECT)
    manager.add_hookspecs(HookSpecs)
    manager.register(plugin)
    manager.check_pending()
    assert manager.hook.mrta_register_renderers() == [{"dashboard": draw_dashboard, "monitor": draw_monitor}]
