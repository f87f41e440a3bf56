# SPDX-License-Identifier: MIT
"""Proximal policy optimization in one file: a pilot learns the merge against the veteran.

    ./eyrie python examples/python/ppo.py                     # 30 minutes on 2 cores
    ./eyrie python examples/python/ppo.py --minutes 2         # to see it begin

Schulman et al., Proximal Policy Optimization Algorithms (arXiv:1707.06347), with generalized advantage
estimation (arXiv:1506.02438). No flight is shown to it: it begins with small random weights, so it flies at the
other as hard as it can, at any speed, and releases its missile at random.
"""

from __future__ import annotations

import argparse
import copy
import os
import time
from pathlib import Path

os.environ.setdefault("OMP_WAIT_POLICY", "PASSIVE")  # beside other work threads that spin stand still

import numpy as np
import torch
from common import OUT, Curve, finish, save_policy, tree_of
from eyrie import envs
from torch import nn

#: What it is told before it begins, the rest is near 0: pull as hard as you can, shoot where the gun bears.
BEGIN = {"load_factor": 1.0, "shoot": 1.0}


def arguments() -> argparse.Namespace:
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    p.add_argument("--task", default="merge", help="merge, or merge_votes: see arbitrate.py")
    p.add_argument("--minutes", type=float, default=30)
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--worlds", type=int, default=256)
    p.add_argument("--threads", type=int, default=2)
    p.add_argument("--opponents", nargs="+", default=["dogfight"], metavar="TREE|FILE.safetensors",
                   help="who is fought, drawn for each episode: trees, and policies of earlier")
    p.add_argument("--out", type=Path, help="default: runs/TASK.safetensors")
    return p.parse_args()


def network(inputs: int, width: int, outputs: int, last: float) -> nn.Sequential:
    """Two hidden layers; orthogonal weights, those of the last layer times `last`."""
    net = nn.Sequential(
        nn.Linear(inputs, width), nn.Tanh(), nn.Linear(width, width), nn.Tanh(),
        nn.Linear(width, outputs)
    )
    for layer, gain in zip(net[::2], (2**0.5, 2**0.5, last), strict=True):
        nn.init.orthogonal_(layer.weight, gain)
        nn.init.zeros_(layer.bias)
    return net


class Learner:
    """What is learned: the mean of the actions, how far they are varied, and what a state is worth."""

    gamma, lam = 0.998, 0.97  # of decisions of 0.1 s: it looks 50 s ahead
    clip, epochs, batch = 0.2, 4, 4096
    rate = 3e-4  # of Adam, falls to a twentieth

    def __init__(self, observation: int, actions: list[str]) -> None:
        self.actor = network(observation, 64, len(actions), 0.01)
        self.critic = network(observation, 128, 1, 1.0)
        self.log_std = nn.Parameter(torch.full((len(actions),), -1.0))
        with torch.no_grad():
            for name, begin in BEGIN.items():
                if name in actions:
                    self.actor[-1].bias[actions.index(name)] = begin
        self.parameters = [*self.actor.parameters(), *self.critic.parameters(), self.log_std]
        self.optimizer = torch.optim.Adam(self.parameters, lr=self.rate, eps=1e-5)

    def log_density(self, seen: torch.Tensor, action: torch.Tensor) -> torch.Tensor:
        z = (action - self.actor(seen)) / self.log_std.exp()
        return (-0.5 * z**2 - self.log_std).sum(-1)

    def value(self, seen: torch.Tensor) -> torch.Tensor:
        return self.critic(seen)[..., 0]

    def learn(self, seen: torch.Tensor, actions: torch.Tensor, advantage: torch.Tensor,
              worth: torch.Tensor) -> None:
        """Some epochs over what was just flown, as long as the policy stays near the one that flew."""
        advantage = (advantage - advantage.mean()) / (advantage.std() + 1e-8)
        with torch.no_grad():
            before = self.log_density(seen, actions)
        for _ in range(self.epochs):
            for rows in torch.randperm(len(seen)).split(self.batch):
                log_ratio = self.log_density(seen[rows], actions[rows]) - before[rows]
                ratio, gain = log_ratio.exp(), advantage[rows]
                clipped = ratio.clamp(1 - self.clip, 1 + self.clip)
                loss = (
                    -torch.min(ratio * gain, clipped * gain).mean()
                    + 0.5 * (self.value(seen[rows]) - worth[rows]).pow(2).mean()
                )
                self.optimizer.zero_grad()
                loss.backward()
                nn.utils.clip_grad_norm_(self.parameters, 0.5)
                self.optimizer.step()
            if (ratio - 1 - log_ratio).mean() > 0.03:  # an estimate of the divergence
                break


class Flights:
    """Many worlds, flown a few decisions at a time."""

    decisions = 64

    def __init__(self, env: envs.VectorEnv, seed: int) -> None:
        self.env = env
        self.seen = torch.tensor(env.reset(seed=seed)[0])
        self.won: list[int] = []  # of each episode that is over: 1, 0, -1

    @torch.no_grad()
    def fly(self, learner: Learner) -> tuple[torch.Tensor, ...]:
        n, steps = self.env.num_envs, self.decisions
        seen = torch.zeros(steps, n, self.seen.shape[1])
        actions = torch.zeros(steps, n, len(self.env.actions))
        rewards, ends, values = torch.zeros(3, steps + 1, n)
        for t in range(steps):
            seen[t] = self.seen
            values[t] = learner.value(self.seen)
            mean = learner.actor(self.seen)
            actions[t] = mean + learner.log_std.exp() * torch.randn_like(mean)
            now, reward, terminated, truncated, infos = self.env.step(
                actions[t].clamp(-1, 1).numpy()
            )
            rewards[t] = torch.tensor(reward)
            over = terminated | truncated
            ends[t] = torch.tensor(over)
            if over.any():
                # who only ran out of time could have gone on: what that is worth belongs to it
                further = learner.value(torch.tensor(infos["final_obs"]))
                rewards[t] += learner.gamma * further * torch.tensor(truncated & ~terminated)
                sign = np.where(terminated, np.sign(reward), 0)  # won or lost outweighs all else
                self.won += sign[over].astype(int).tolist()
            self.seen = torch.tensor(now)
        values[steps] = learner.value(self.seen)

        advantage = torch.zeros(steps + 1, n)
        for t in reversed(range(steps)):
            on = 1 - ends[t]
            error = rewards[t] + learner.gamma * on * values[t + 1] - values[t]
            advantage[t] = error + learner.gamma * learner.lam * on * advantage[t + 1]
        worth = advantage + values
        return (seen.flatten(0, 1), actions.flatten(0, 1), advantage[:-1].flatten(),
                worth[:-1].flatten())


def train(task: str, minutes: float, seed: int, worlds: int, threads: int,
          opponents: list[str], out: Path) -> None:
    torch.manual_seed(seed)
    torch.set_num_threads(threads)
    env = envs.VectorEnv(task, worlds, threads=threads, opponents={"bandit1": opponents})
    learner = Learner(env.single_observation_space.shape[0], env.actions)
    flights, curve = Flights(env, seed), Curve(out.with_suffix(".csv"))
    begun, decisions, best = time.monotonic(), 0, learner.actor
    while (spent := (time.monotonic() - begun) / 60) < minutes:
        for group in learner.optimizer.param_groups:
            group["lr"] = learner.rate * max(1 - spent / minutes, 0.05)
        flown = flights.fly(learner)
        decisions += len(flown[0])
        if curve.add(spent, decisions, flights.won):
            best = copy.deepcopy(learner.actor)
        learner.learn(*flown)
    curve.draw(f"PPO on {task}, seed {seed}")
    save_policy(out, best, [(0, "tanh"), (2, "tanh"), (4, "none")], env.policy_words)
    env.close()


if __name__ == "__main__":
    given = arguments()
    policy = given.out or OUT / f"{given.task}.safetensors"
    train(given.task, given.minutes, given.seed, given.worlds, given.threads, given.opponents,
          policy)
    finish(given.task, tree_of(given.task, policy))
