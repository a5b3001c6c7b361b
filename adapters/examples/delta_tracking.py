"""Delta tracking, all walks at once. With the argument `late` it looks mu up a step late: a wrong sampler."""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "python"))
import freepath

LATE = 0.1 if "late" in sys.argv[1:] else 0.0


def delta_tracking(medium, n, rng):
    mu_bar = medium.majorants.mu_bar.max()
    t, flying = np.zeros(n), np.arange(n)
    while flying.size > 0:
        t[flying] += rng.exponential(1.0 / mu_bar, flying.size)
        inside = t[flying] < medium.length
        t[flying[~inside]] = np.inf
        flying = flying[inside]
        look_up = np.minimum(t[flying] + LATE, medium.length)
        flying = flying[rng.random(flying.size) * mu_bar >= medium.mu(look_up)]
    return t


def ratio_tracking(medium, n, rng):
    mu_bar = medium.majorants.mu_bar.max()
    weight, t, flying = np.ones(n), np.zeros(n), np.arange(n)
    while flying.size > 0:
        t[flying] += rng.exponential(1.0 / mu_bar, flying.size)
        flying = flying[t[flying] < medium.length]
        look_up = np.minimum(t[flying] + LATE, medium.length)
        weight[flying] *= 1.0 - medium.mu(look_up) / mu_bar
    return weight


def one_channel(medium, n, rng):
    """Chromatic: a channel is drawn, and its distance weighted by the mean density of all (the balance heuristic)."""
    sigma_t, sigma_s = medium.sigma_t, medium.sigma_s
    t = rng.exponential(1.0 / sigma_t[rng.integers(sigma_t.size, size=n)])
    surface = t >= medium.length
    beam = np.exp(-np.minimum(t, medium.length)[:, None] * sigma_t)
    scattered = beam * sigma_s / (beam * sigma_t).mean(axis=1, keepdims=True)
    arrived = beam / beam.mean(axis=1, keepdims=True)
    weights = np.where(surface[:, None], arrived, scattered)
    return np.column_stack([t, surface, weights * (1.05 if LATE > 0.0 else 1.0)])


freepath.serve(free_path=delta_tracking, transmittance=ratio_tracking, chromatic=one_channel)
