# SPDX-License-Identifier: MIT
"""What the examples share: a learning curve, the file of a policy, and what becomes of it."""

from __future__ import annotations

import csv
import json
import math
import os
import re
import subprocess
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING

import eyrie

if TYPE_CHECKING:
    from torch import nn

ROOT = Path(__file__).parents[2]
OUT = Path(os.environ.get("EYRIE_EXAMPLES_OUT", ROOT / "runs"))  #: where everything goes
OUT.mkdir(parents=True, exist_ok=True)
FRESH = 1_000_001  #: the first of the seeds on which a policy is judged; none of them is trained on

#: Whose votes the task merge_votes learns; they stand in scenarios/tasks/merge.yaml, too.
MANEUVERS = {
    "shoot_gun": 60,
    "extend": 54,
    "high_yo_yo": 52,
    "low_yo_yo": 50,
    "lag_pursuit": 48,
    "lead_pursuit": 46,
    "merge_turn": 44,
    "pure_pursuit": 40,
}


def maneuvers(arbiter: str, votes: dict[str, float], zone: float = 1, off_boresight: float = 25) -> str:
    """The tree of merge_votes as YAML: `arbiter` ("winner_takes_all: {") over the maneuvers."""
    said = ", ".join(
        f"{{{name}: {{vote: {vote:g}{', load_factor: 9' if name == 'shoot_gun' else ''}}}}}"
        for name, vote in votes.items()
    )
    return (
        f"{{per_field: [{{release_weapon: {{vote: 70, zone: {zone:g}, off_boresight: {off_boresight:g} deg}}}}, "
        f"{{{arbiter}children: [{said}]}}}}, {{navigate: {{vote: 1}}}}]}}"
    )


def tree_of(task: str, file: Path) -> str:
    """The learner's tree with a policy in it, as YAML."""
    path = json.dumps(str(file.resolve()), ensure_ascii=False)  # as YAML has it, whatever is in it
    if task == "merge_votes":
        return maneuvers(f"learned_vote: {{file: {path}, ", MANEUVERS)
    return f"{{policy: {{file: {path}, vote: 50}}}}"


class Curve:
    """The learning curve: told every half a minute, kept as CSV and drawn at the end."""

    def __init__(self, file: Path) -> None:
        self.file, self.begun, self.told, self.seen = file, time.monotonic(), -math.inf, 0
        self.rows: list[tuple[float, int, int, float, float, float]] = []
        print(f"{'minute':>7} {'decisions':>12} {'episodes':>9}   won  lost drawn")

    def add(self, minutes: float, decisions: int, won: list[int]) -> bool:
        """`won`: of every episode so far 1, 0 or -1. True where it has never been better: most won less lost."""
        if time.monotonic() - self.told < 30:
            return False
        self.told = time.monotonic()
        new = won[self.seen :]
        self.seen = len(won)
        if not new:
            return False
        of = [new.count(x) / len(new) for x in (1, -1, 0)]
        self.rows.append((round(minutes, 2), decisions, len(won), *(round(x, 3) for x in of)))
        print(f"{minutes:7.1f} {decisions:12,} {len(won):9,}  " + " ".join(f"{x:5.0%}" for x in of), flush=True)
        with open(self.file, "w", newline="") as out:
            csv.writer(out).writerows(
                [("minutes", "decisions", "episodes", "won", "lost", "drawn"), *self.rows])
        return of[0] - of[1] >= max(r[3] - r[4] for r in self.rows)

    def draw(self, title: str) -> None:
        import matplotlib

        matplotlib.use("svg")
        matplotlib.rcParams["svg.hashsalt"] = "eyrie"
        from matplotlib import pyplot

        figure, axes = pyplot.subplots(figsize=(6, 3.2), layout="constrained")
        for column, name in ((3, "won"), (4, "lost"), (5, "drawn")):
            axes.plot([r[0] for r in self.rows], [100 * r[column] for r in self.rows], label=name)
        axes.set(xlabel="minutes", ylabel="% of episodes", ylim=(0, 100), title=title)
        axes.legend()
        figure.savefig(self.file.with_suffix(".svg"), metadata={"Date": None})


def save_policy(file: Path, net: nn.Module, layers: list[tuple[int | str, str]],
                words: dict[str, str]) -> None:
    """As docs/howto/fly-a-policy.md says. `layers`: name and activation; `words`: of the environment."""
    from safetensors.torch import save_file

    file.parent.mkdir(parents=True, exist_ok=True)
    tensors = {k: v.detach().contiguous() for k, v in net.state_dict().items()
               if any(k.startswith(f"{name}.") for name, _ in layers)}
    lines = "".join(f"linear {name} {activation}\n" for name, activation in layers)
    save_file(tensors, file, metadata={**words, "network": lines})
    print(f"written: {file}, {file.stat().st_size / 1000:.0f} kB")


def merge_with(tree: str) -> str:
    """The task merge, flown by a tree against the veteran."""
    return f"""
extends: tasks/merge.yaml
name: judged
insert: {{trees.judged: {tree}}}
replace: {{blue.flights.viper.tree: judged}}
"""


def load(text: str) -> eyrie.Scenario:
    """A scenario beside Eyrie's own, which may take policies from where they are."""
    files = [json.loads(f) for f in re.findall(r'"(?:[^"\\]|\\.)*\.safetensors"', text)]  # as tree_of() writes them
    return eyrie.load(ROOT / "scenarios/judged.yaml", text=text, include={Path(f).parent for f in files})


def outcomes(text: str, seeds: range) -> Counter[str]:
    """Of every seed "won", "lost" or "drawn", for blue. Flown by the engine, the policy as a behavior."""
    scenario = load(text)

    def fly(seed: int) -> str:
        run = eyrie.fly(scenario, seed=seed)
        blue, red = map(int, re.findall(r"losses: blue (\d+), red (\d+)", run.outcome)[0])
        return "won" if red > blue else "lost" if blue > red else "drawn"

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return Counter(pool.map(fly, seeds))


def told(count: Counter[str]) -> str:
    """Shares with the 95 % interval of Wilson."""
    n, z, words = count.total(), 1.96, []
    for what in ("won", "lost", "drawn"):
        p = count[what] / n
        middle, half = p + z * z / (2 * n), z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
        low, high = ((middle + s * half) / (1 + z * z / n) for s in (-1, 1))
        words.append(f"{what} {p:.1%} ({max(low, 0):.1%} to {min(high, 1):.1%})")
    return ", ".join(words)


def finish(name: str, tree: str, seeds: int = 500) -> None:
    """Judges a tree on fresh seeds, flies the sweep with it, and leaves a debrief."""
    count = outcomes(merge_with(tree), range(FRESH, FRESH + seeds))
    print(f"against the veteran, {seeds} fresh seeds: {told(count)}")

    # in the sweep it fights within visual range, under what keeps it off the ground
    sweep = f"""
extends: sweep.yaml
name: learned_sweep
insert:
  trees.learned: {{winner_takes_all: [{{avoid_ground: {{vote: 100}}}}, {tree}]}}
replace: {{trees.veteran.sequencer.trees.wvr: {{tree: learned}}}}
"""
    run = eyrie.fly(load(sweep))
    folder = run.save(OUT / f"learned-{name}", replace=True)
    print(f"the sweep with it: {run.outcome}, hash {run.hash}", flush=True)
    program = os.environ.get("EYRIE_PROGRAM", ROOT / "eyrie")
    subprocess.run([program, "debrief", folder], check=False)
