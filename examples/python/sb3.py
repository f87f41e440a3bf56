# SPDX-License-Identifier: MIT
"""The same with Stable-Baselines3, in ten lines; then its policy flies as a behavior."""

import eyrie.envs  # noqa: F401 - registers the tasks
from common import OUT, finish, save_policy, tree_of
from stable_baselines3 import PPO
from stable_baselines3.common.env_util import make_vec_env

env = make_vec_env("Eyrie/Merge-v0", n_envs=16)
model = PPO("MlpPolicy", env, n_steps=512, batch_size=2048, gamma=0.998, gae_lambda=0.97, policy_kwargs={"log_std_init": -1.0},
            seed=1, device="cpu", verbose=1)
model.learn(total_timesteps=3_000_000)

out = OUT / "merge_sb3.safetensors"
layers = [("mlp_extractor.policy_net.0", "tanh"), ("mlp_extractor.policy_net.2", "tanh"), ("action_net", "none")]
save_policy(out, model.policy, layers, env.envs[0].unwrapped.policy_words)
finish("sb3", tree_of("merge", out))
