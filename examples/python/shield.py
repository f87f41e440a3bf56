# SPDX-License-Identifier: MIT
"""What a shield is worth: the learned pilot with and without avoid_ground and verify above it.

    ./eyrie python examples/python/shield.py [--seeds 1000]

The limits are two rules of training, which nobody told the network (AFI 11-214 as docs/models/fight.md has it): not
below a floor of 5,000 ft, and no gun nose to nose, at more than 135 degrees of aspect. `verify` refuses what breaks
one at once, and takes the next proposal; `avoid_ground` outvotes the pilot near the floor. What comes of it is
measured on the true flights.
"""

from __future__ import annotations

import argparse
import os
import re
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import eyrie
import numpy as np
from common import FRESH, ROOT, load, merge_with, told, tree_of

FLOOR = 5000 * 0.3048
NOSE_TO_NOSE = 135.0

AVOID = "{avoid_ground: {vote: 100, floor: 5000 ft, warning_time: 6 s}}"
REFUSE = "[action.trigger and off_tail > 135 deg, altitude < 6500 ft and action.climb < 0 deg]"


def trees(file: Path) -> dict[str, str]:
    pilot = tree_of("merge", file)
    verify = f"{{verify: {{refuse: {REFUSE}, fallback: true, children: [{pilot}, {{pure_pursuit: {{vote: 40}}}}, {{navigate: {{vote: 1}}}}]}}}}"
    return {
        "alone": pilot,
        "avoid_ground": f"{{winner_takes_all: [{AVOID}, {pilot}]}}",
        "verify": verify,
        "both": f"{{winner_takes_all: [{AVOID}, {verify}]}}",
    }


def judge(run: eyrie.Run) -> dict[str, float]:
    """How it ended, whether he crashed, and for how long which limit was broken."""
    tracks, decided = run.tracks(every=0.1), run.decisions("viper1")
    mine = tracks[tracks["player"] == "viper1"]
    other = tracks[tracks["player"] == "bandit1"]
    n = min(len(mine), len(other), len(decided))
    mine, other, decided = mine[:n], other[:n], decided[:n]
    # off the other's tail: between his course and the line from me to him
    line = np.stack([other[a] - mine[a] for a in ("north_m", "east_m", "altitude_m")], 1)
    up, course = np.radians(other["pitch_deg"]), np.radians(other["heading_deg"])
    flies = np.stack([np.cos(up) * np.cos(course), np.cos(up) * np.sin(course), np.sin(up)], 1)
    cosine = (line * flies).sum(1) / np.maximum(np.linalg.norm(line, axis=1), 1)
    nose_to_nose = np.degrees(np.arccos(np.clip(cosine, -1, 1))) > NOSE_TO_NOSE
    crashes = run.events[(run.events["event"] == "crash") & (run.events["who"] == "viper1")]
    blue, red = map(int, re.findall(r"losses: blue (\d+), red (\d+)", run.outcome)[0])
    return {
        "won": float(red > blue),
        "lost": float(blue > red),
        "crashed": float(len(crashes) > 0),
        "below": float((mine["altitude_m"] < FLOOR).sum()) / 10,
        "shot": float(((decided["trigger_order"] == 1) & nose_to_nose).sum()) / 10,
    }


def main() -> None:
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    p.add_argument("--seeds", type=int, default=1000)
    p.add_argument("--policy", type=Path,
                   default=ROOT / "scenarios/policies/merge.safetensors")
    given = p.parse_args()
    seeds = range(FRESH, FRESH + given.seeds)
    print("| above the learned pilot | outcome | crashed | flights below the floor | s below, all "
          "| flights with a gun nose to nose | s of it, all |\n| --- | --- | ---: | ---: | ---: | ---: | ---: |")
    for name, tree in trees(given.policy).items():
        scenario = load(merge_with(tree))
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            all_of = list(pool.map(lambda s, of=scenario: judge(eyrie.fly(of, seed=s)), seeds))
        ends = Counter("won" if r["won"] else "lost" if r["lost"] else "drawn" for r in all_of)
        below, shot = (np.array([r[k] for r in all_of]) for k in ("below", "shot"))
        crashed = sum(r["crashed"] for r in all_of)
        print(f"| {name} | {told(ends)} | {crashed:.0f} | {(below > 0).sum()} | {below.sum():.0f} "
              f"| {(shot > 0).sum()} | {shot.sum():.1f} |", flush=True)


if __name__ == "__main__":
    main()
