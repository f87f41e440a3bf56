# SPDX-License-Identifier: MIT
"""Eyrie: simulation of autonomous agents, deterministic, fast, and open about its decisions.

>>> import eyrie
>>> run = eyrie.fly("sweep", seed=7, set={"blue.flights.eagle.tree": "veteran"})
>>> run.events[run.events["event"] == "launch"]["who"]
>>> print(run.explain("eagle1", at=500))

docs/python.md tells the rest.
"""

from ._core import version as __version__
from ._errors import ConfigError, Error, FaultError, MissingError, Problem, RunError
from ._run import Explanation, Run, StoryLine, fly, open
from ._scenario import Player, Scenario, load, scenarios
from ._tables import Column, Table
from ._world import Field, World

__all__ = [
    "Column",
    "ConfigError",
    "Error",
    "Explanation",
    "FaultError",
    "Field",
    "MissingError",
    "Player",
    "Problem",
    "Run",
    "RunError",
    "Scenario",
    "StoryLine",
    "Table",
    "World",
    "__version__",
    "fly",
    "load",
    "open",
    "scenarios",
]
