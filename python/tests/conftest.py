# SPDX-License-Identifier: MIT
"""What the tests share. They run against the installed package, away from the sources."""

from __future__ import annotations

import pytest

import eyrie

#: a short one: two against two, over in a minute
SHORT = "merge"


@pytest.fixture(scope="session")
def scenario() -> eyrie.Scenario:
    return eyrie.load(SHORT)


@pytest.fixture(scope="session")
def run(scenario: eyrie.Scenario) -> eyrie.Run:
    return eyrie.fly(scenario)


@pytest.fixture(scope="session")
def player(run: eyrie.Run) -> str:
    """One that decides."""
    return str(run.decisions()["player"][0])
