# SPDX-License-Identifier: MIT
"""Parameters of a tree without gradients: the cross-entropy method over the votes and parameters of a fight.

    ./eyrie python examples/python/tune_tree.py

Rubinstein & Kroese, The Cross-Entropy Method (2004), in its form for continuous parameters with smoothing: draw
candidates from a normal distribution, fly each, fit the distribution to the best eighth. All candidates of a
generation fly the same seeds, so that luck is common to them. What wins is a tree in YAML, without a network.
(`eyrie optimize` has CMA-ES and a store that can be resumed.)
"""

from __future__ import annotations

import argparse

import numpy as np
from common import FRESH, MANEUVERS, OUT, finish, maneuvers, merge_with, outcomes, told

#: name -> the least, the most, what was written by hand
PARAMETERS = {
    "zone": (0.3, 1.2, 1.0),
    "off_boresight": (5.0, 40.0, 25.0),  # deg
    **{name: (0.0, 100.0, float(vote)) for name, vote in MANEUVERS.items()},
}
LOW, HIGH, BY_HAND = np.array(list(PARAMETERS.values())).T


def tree(x: np.ndarray) -> str:
    """The candidate as YAML."""
    zone, off_boresight, *votes = (round(float(v), 3) for v in x)
    return maneuvers("winner_takes_all: {", dict(zip(MANEUVERS, votes, strict=True)), zone, off_boresight)


def main() -> None:
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    p.add_argument("--generations", type=int, default=12)
    p.add_argument("--candidates", type=int, default=40)
    p.add_argument("--seeds", type=int, default=24, help="that each candidate flies")
    p.add_argument("--judged", type=int, default=500, help="fresh seeds at the end")
    p.add_argument("--seed", type=int, default=1)
    given = p.parse_args()
    draw = np.random.default_rng(given.seed)
    mean, spread = (LOW + HIGH) / 2, (HIGH - LOW) / 3
    print("generation  best  mean of all  (won less lost, of 1)")
    for generation in range(given.generations):
        candidates = np.clip(draw.normal(mean, spread, (given.candidates, len(LOW))), LOW, HIGH)
        first = 1 + generation * given.seeds
        scores = np.array([
            (count["won"] - count["lost"]) / count.total()
            for count in (outcomes(merge_with(tree(x)), range(first, first + given.seeds))
                          for x in candidates)
        ])
        elite = candidates[np.argsort(-scores)[: max(2, given.candidates // 8)]]
        mean = 0.3 * mean + 0.7 * elite.mean(0)
        spread = 0.3 * spread + 0.7 * elite.std(0) + 0.01 * (HIGH - LOW)
        print(f"{generation + 1:10} {scores.max():5.2f} {scores.mean():12.2f}", flush=True)
    by_hand = outcomes(merge_with(tree(BY_HAND)), range(FRESH, FRESH + given.judged))
    print(f"written by hand, {given.judged} fresh seeds: {told(by_hand)}")
    out = OUT / "tuned_fight.yaml"
    out.write_text(f"# Found by tune_tree.py: a package for 'include:'.\ntrees:\n  tuned_fight: {tree(mean)}\n")
    print(f"written: {out}")
    finish("tuned", tree(mean), given.judged)


if __name__ == "__main__":
    main()
