"""What is registered, told without importing any plugin.

* ``entries``: architectures, applications and plugins; ``description``: one of them in full
* ``plugins``: who implements which hook
* ``taxonomy_filter``: which of them are asked for
"""
