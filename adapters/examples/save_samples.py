"""Free paths by delta tracking in the medium of cases/gaussian.json, saved for `freepath check`: save_samples.py FILE.npy"""

import sys

import numpy as np

PEAK, CENTER, WIDTH, LENGTH = 4.0, 0.9, 0.25, 2.0


def mu(t):
    return PEAK * np.exp(-0.5 * ((t - CENTER) / WIDTH) ** 2)


rng = np.random.default_rng(1)
t, flying = np.zeros(300_000), np.arange(300_000)
while flying.size > 0:
    t[flying] += rng.exponential(1.0 / PEAK, flying.size)
    t[flying[t[flying] >= LENGTH]] = np.inf
    flying = flying[t[flying] < LENGTH]
    flying = flying[rng.random(flying.size) * PEAK >= mu(t[flying])]
np.save(sys.argv[1], t)
