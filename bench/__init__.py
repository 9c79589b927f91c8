"""Comparisons with peers: pure measuring code, for ``mrta bench`` and for engineers."""
