#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes what the study found as text (results.md) and figures (*.svg), from the folders of its campaigns.

usage: tables.py FOLDER     with compare/, starts/ and same/, which were reported with --of swept
"""
import collections
import json
import math
import pathlib
import random
import sqlite3
import sys

NAMES = ["winner_takes_all", "behavior_tree", "per_field", "sequencer", "subsumption", "weighted_fusion", "paper_fusion"]


def report(folder):
    """What the page of a campaign shows."""
    page = (folder / "report.html").read_text()
    begin = page.index('id="data">') + len('id="data">')
    return json.loads(page[begin : page.index("</script>", begin)])


def entropy(counts):
    """In bits, with the correction of Miller and Madow for few samples."""
    n = sum(counts)
    plain = -sum(c / n * math.log2(c / n) for c in counts)
    return plain + (len(counts) - 1) / (2 * n * math.log(2))


def outcomes(folder, by):
    """architecture -> the start and the outcome of each flight: losses of both sides, and how it ended."""
    database = sqlite3.connect(f"file:{folder / 'results.db'}?mode=ro", uri=True)
    found = {}
    start = " || ' ' || ".join(by) if by else "''"
    for architecture, where, *outcome in database.execute(
        f"SELECT architecture, {start}, blue_losses, red_losses, outcome FROM replicates JOIN cells USING (cell) "
        "ORDER BY cell, replicate"
    ):
        found.setdefault(architecture, []).append((where, tuple(outcome)))
    return found


def pooled(folder):
    return {a: entropy(collections.Counter(o for _, o in of).values()) for a, of in outcomes(folder, []).items()}


def given_start(folder, shuffles=200):
    """The mean entropy of the outcomes of one start, less what few flights of each take from it: with starts dealt at
    random it would be that of all."""

    def mean_entropy(starts, ends):
        by_start = {}
        for start, end in zip(starts, ends):
            by_start.setdefault(start, collections.Counter())[end] += 1
        return sum(entropy(counts.values()) for counts in by_start.values()) / len(by_start)

    found, chance = {}, random.Random(1)
    for a, of in outcomes(folder, ["north", "altitude", "heading"]).items():
        starts, ends = zip(*of)
        by_chance = sum(mean_entropy(chance.sample(starts, len(starts)), ends) for _ in range(shuffles)) / shuffles
        found[a] = mean_entropy(starts, ends) - by_chance + entropy(collections.Counter(ends).values())
    return found


class Chart:
    """Rows of dots with their intervals: hollow as written, filled as tuned."""

    WIDTH, LEFT, ROW, TOP = 640, 150, 34, 46

    def __init__(self, title, low, high, unit=""):
        self.low, self.high, self.parts = low, high, []
        height = self.TOP + self.ROW * len(NAMES) + 34
        self.parts.append(
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.WIDTH} {height}" font-family="sans-serif" '
            f'font-size="12"><rect width="100%" height="100%" fill="#fff"/>'
            f'<text x="10" y="20" font-size="14" font-weight="bold" fill="#222">{title}</text>'
            f'<text x="{self.WIDTH - 10}" y="20" text-anchor="end" fill="#555">○ as written  ● tuned</text>'
        )
        bottom = self.TOP + self.ROW * len(NAMES)
        step = 10 ** math.floor(math.log10((high - low) / 2))
        step *= next(f for f in (1, 2, 5, 10) if (high - low) / (f * step) <= 8)
        for i in range(math.ceil(low / step), math.floor(high / step) + 1):
            x = self.x(i * step)
            self.parts.append(
                f'<line x1="{x}" y1="{self.TOP - 10}" x2="{x}" y2="{bottom}" stroke="#ddd"/>'
                f'<text x="{x}" y="{bottom + 18}" text-anchor="middle" fill="#555">{i * step:g}{unit}</text>'
            )
        for i, name in enumerate(NAMES):
            self.parts.append(
                f'<text x="{self.LEFT - 12}" y="{self.TOP + self.ROW * (i + 0.5) + 1}" text-anchor="end" fill="#222">'
                f"{name.replace('_', ' ')}</text>"
            )

    def x(self, value):
        return round(self.LEFT + (value - self.low) / (self.high - self.low) * (self.WIDTH - self.LEFT - 30), 1)

    def dot(self, name, tuned, value, interval=None):
        y = self.TOP + self.ROW * (NAMES.index(name) + (0.62 if tuned else 0.28))
        colour = "#0b5fa5" if tuned else "#c2570c"
        if interval:
            ends = [self.x(min(max(end, self.low), self.high)) for end in interval]
            self.parts.append(f'<line x1="{ends[0]}" y1="{y}" x2="{ends[1]}" y2="{y}" stroke="{colour}" stroke-width="2"/>')
        self.parts.append(
            f'<circle cx="{self.x(value)}" cy="{y}" r="4.5" stroke="{colour}" stroke-width="2" '
            f'fill="{colour if tuned else "#fff"}"/>'
        )

    def write(self, path):
        path.write_text("\n".join(self.parts) + "</svg>\n")


def table(head, rows):
    return "\n".join(["| " + " | ".join(row) + " |" for row in [head, ["---"] + ["---:"] * (len(head) - 1), *rows]]) + "\n"


def estimates(data):
    """architecture -> measure -> [value, low, high, n]"""
    names = [m["name"] for m in data["measures"]]
    architecture = data["factors"].index("architecture")
    return {cell["values"][architecture]: dict(zip(names, cell["estimates"])) for cell in data["cells"]}


def number(estimate, scale=1, digits=2):
    value, low, high = (None if x is None else scale * x for x in estimate[:3])
    if value is None:
        return "–"
    shown = f"{value:.{digits}f}"
    return shown if low is None or high is None else f"{shown} ({low:.{digits}f} to {high:.{digits}f})"


def main():
    out = pathlib.Path(sys.argv[1])
    compare, starts = out / "compare", out / "starts"
    data, there, same = report(compare), report(starts), report(out / "same")
    found = estimates(data)
    names = [name + suffix for name in NAMES for suffix in ("", "_tuned")]

    for measure, title, scale, unit in (
        ("swept", "Missions in which the area is swept", 100, " %"),
        ("exchange", "Bogeys lost per eagle lost", 1, ""),
        ("blue_losses", "Eagles lost of four", 1, ""),
        ("all_home", "Missions in which all who live are home", 100, " %"),
    ):
        ends = [x for name in names for x in found[name][measure] if x is not None]
        chart = Chart(title, 0, scale * max(ends) * 1.03, unit)
        for name in NAMES:
            for tuned in (False, True):
                value, low, high = found[name + "_tuned" * tuned][measure]
                if value is not None:
                    interval = None if low is None or high is None else (scale * low, scale * high)
                    chart.dot(name, tuned, scale * value, interval)
        chart.write(out / f"{measure}.svg")

    nominal, spread, given = pooled(compare), pooled(starts), given_start(starts)
    chart = Chart("Entropy of the outcomes over perturbed starts, bits", 0, 1.03 * max(spread.values()))
    for name in NAMES:
        for tuned in (False, True):
            chart.dot(name, tuned, spread[name + "_tuned" * tuned])
    chart.write(out / "entropy.svg")

    text = [
        "# What the flights say\n\nWritten by `tables.py`; the words about it are in [README.md](README.md). Intervals: 95 %.\n",
        f"`compare.yaml`: {sum(c['replicates'] for c in data['cells'])} flights, campaign hash `{data['hash']}`; "
        f"`starts.yaml`: {sum(c['replicates'] for c in there['cells'])} flights, `{there['hash']}`; "
        f"`same.yaml`: {sum(c['replicates'] for c in same['cells'])} flights, `{same['hash']}`.\n",
        "## Each by itself\n",
        table(
            ["", "swept, %", "eagles lost of 4", "bogeys lost of 2", "exchange", "shots per kill", "all home, %"],
            [
                [
                    name.replace("_", " "),
                    number(found[name]["swept"], 100, 1),
                    number(found[name]["blue_losses"]),
                    number(found[name]["red_losses"]),
                    number(found[name]["exchange"]),
                    number(found[name]["shots_per_kill"], 1, 1),
                    number(found[name]["all_home"], 100, 1),
                ]
                for name in names
            ],
        ),
    ]

    architecture = data["factors"].index("architecture")
    cells = {cell["values"][architecture]: i for i, cell in enumerate(data["cells"])}
    swept = [m["name"] for m in data["measures"]].index("swept")
    pairs = {(c["cell"], c["than"]): c for c in data["comparisons"] if c["measure"] == swept}

    def against(one, other):
        a, b = cells[one], cells[other]
        c = pairs.get((a, b)) or pairs[(b, a)]
        sign = 100 if (a, b) in pairs else -100
        sure = "**" if c["holm"] < 0.05 else ""
        return f"{sure}{sign * c['value'] + 0:+.1f}{sure}"

    for suffix, title in (("_tuned", "tuned"), ("", "as written")):
        text.append(
            f"## Row less column, points of missions swept, {title}\n\nPairs of the same seeds; bold where McNemar's test, corrected "
            f"by Holm for all {len(pairs)} pairs, gives p < 0.05.\n"
        )
        text.append(
            table(
                [""] + [name.replace("_", " ") for name in NAMES],
                [
                    [one.replace("_", " ")] + ["" if one == other else against(one + suffix, other + suffix) for other in NAMES]
                    for one in NAMES
                ],
            )
        )
    text.append("## What tuning did, points of missions swept\n")
    text.append(
        table(["", "tuned less as written"], [[n.replace("_", " "), against(n + "_tuned", n)] for n in NAMES])
    )

    alike = estimates(same)
    arbiters = same["factors"].index("architecture")
    numbers = [cell["values"][arbiters] for cell in same["cells"]]
    ofs = [m["name"] for m in same["measures"]].index("swept")
    less = {
        (numbers[c["cell"]], numbers[c["than"]]): (100 * c["value"], c["holm"])
        for c in same["comparisons"]
        if c["measure"] == ofs
    }

    def from_first(name):
        first = "winner_takes_all"
        if name == first:
            return ""
        value, p = less.get((name, first)) or (-less[(first, name)][0], less[(first, name)][1])
        return f"{value + 0:+.1f} (p {p:.2g})"

    text.append(
        "## With the parameters that were found for winner takes all\n\nThe same seeds; p is McNemar's, corrected by Holm for all "
        f"{len(less)} pairs.\n"
    )
    text.append(
        table(
            ["", "swept, %", "less winner takes all, points", "eagles lost of 4", "bogeys lost of 2", "all home, %"],
            [
                [
                    name.replace("_", " "),
                    number(alike[name]["swept"], 100, 1),
                    from_first(name),
                    number(alike[name]["blue_losses"]),
                    number(alike[name]["red_losses"]),
                    number(alike[name]["all_home"], 100, 1),
                ]
                for name in NAMES
            ],
        )
    )

    around = {}
    for name in names:
        of = [dict(zip([m["name"] for m in there["measures"]], c["estimates"])) for c in there["cells"] if name in c["values"]]
        around[name] = {m: sum(e[m][0] for e in of) / len(of) for m in ("swept", "variety", "motion")}
    text.append(
        "## How consistent, how various\n\nEntropies in bits (Miller and Madow's correction). Outcomes: losses of both sides and how it "
        "ended. Of the 27 starts of `starts.yaml` (20 seeds each), *in one start* is what chance leaves open, the difference "
        "what the way the enemy comes in decides, less what starts dealt at random would. Leaders: which type of node led the decisions of a flight (a fusion leads itself); "
        "motion: bank and climb at the decisions.\n"
    )
    text.append(
        table(
            ["", "outcomes, nominal start", "outcomes, 27 starts", "in one start", "swept there, %", "leaders", "motion"],
            [
                [
                    name.replace("_", " "),
                    f"{nominal[name]:.2f}",
                    f"{spread[name]:.2f}",
                    f"{given[name]:.2f}",
                    f"{100 * around[name]['swept']:.1f}",
                    f"{around[name]['variety']:.2f}",
                    f"{around[name]['motion']:.2f}",
                ]
                for name in names
            ],
        )
    )
    (out / "results.md").write_text("\n".join(text))


if __name__ == "__main__":
    main()
