"""What is registered, told without importing any plugin.

* ``entries``: architectures and applications, a line each
* ``package``: all that one package registers, in full; ``description``, ``parameter_rows``: of what this consists
* ``plugins``: who implements which hook
* ``taxonomy_filter``: which of them are asked for
"""
