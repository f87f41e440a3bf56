# SPDX-License-Identifier: MIT
"""Learning to arbitrate: the votes of eight maneuvers written by hand are learned, beside those written by hand.

    ./eyrie python examples/python/arbitrate.py

The behaviors stay as they are; a network says which of them is heard. So what the pilot may do is known, and
`explain` says at every moment which maneuver won, with which vote.
"""

from __future__ import annotations

import argparse

from common import FRESH, OUT, finish, merge_with, outcomes, told, tree_of
from ppo import train

if __name__ == "__main__":
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    p.add_argument("--minutes", type=float, default=10)
    p.add_argument("--seed", type=int, default=1)
    given = p.parse_args()
    policy = OUT / "merge_votes.safetensors"
    train("merge_votes", given.minutes, given.seed, 256, 1, ["dogfight"], policy)
    by_hand = outcomes(merge_with("{tree: arbitrated}"), range(FRESH, FRESH + 500))
    print(f"the votes written by hand, 500 fresh seeds: {told(by_hand)}")
    finish("merge_votes", tree_of("merge_votes", policy))
