# SPDX-License-Identifier: MIT
"""Eyrie: simulation of autonomous agents, deterministic, fast, and open about its decisions.

>>> import eyrie
>>> run = eyrie.fly("sweep", seed=7, set={"blue.flights.eagle.tree": "veteran"})
>>> run.events[run.events["event"] == "launch"]["who"]
>>> print(run.explain("eagle1", at=500))

docs/python.md tells the rest.
"""

from ._core import version as __version__
from ._behavior import Behavior, Proposal, State, behavior, param, propose
from ._errors import ConfigError, Error, FaultError, MissingError, Problem, RunError
from ._run import Explanation, Run, StoryLine, fly, open
from ._scenario import Player, Scenario, load, scenarios
from ._tables import Column, Field, Table
from ._world import World

__all__ = [
    "Behavior",
    "Column",
    "ConfigError",
    "Error",
    "Explanation",
    "FaultError",
    "Field",
    "MissingError",
    "Player",
    "Problem",
    "Proposal",
    "Run",
    "RunError",
    "Scenario",
    "State",
    "StoryLine",
    "Table",
    "World",
    "__version__",
    "behavior",
    "fly",
    "load",
    "open",
    "param",
    "propose",
    "scenarios",
]
