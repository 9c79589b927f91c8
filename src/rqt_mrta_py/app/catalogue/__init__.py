"""What is registered, told without importing any plugin but those that make missions.

* ``entries``: architectures and applications, a line each
* ``package``: all that one package registers, in full; ``description``, ``parameter_rows``: of what this consists
* ``mission_settings``: what can be set of an application's mission
* ``plugins``: who implements which hook
* ``taxonomy_filter``: which of them are asked for
"""
