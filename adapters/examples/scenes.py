"""Samplers in scenes without a ray. With the argument `wrong` the uniform that all begin with is a little too small."""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "python"))
import freepath

SHRINK = 0.95 if "wrong" in sys.argv[1:] else 1.0


def uniform(n, rng):
    return SHRINK * rng.random(n)


def ramp(scene, n, rng):
    """The density x/2 on [0, 2], by inversion."""
    return 2.0 * np.sqrt(uniform(n, rng))


def search(scene, n, rng):
    cumulative = np.cumsum(np.array(scene.parameters["weights"], dtype=float))
    return np.searchsorted(cumulative / cumulative[-1], uniform(n, rng), side="right")


def cosine(scene, n, rng):
    """The cosine law about any normal: a point of the unit sphere on top of the normal (Shirley 2011)."""
    z, phi = 1.0 - 2.0 * uniform(n, rng), 2.0 * np.pi * rng.random(n)
    r = np.sqrt(1.0 - z * z)
    w = np.column_stack([r * np.cos(phi), r * np.sin(phi), z]) + scene.parameters["normal"]
    return w / np.linalg.norm(w, axis=1, keepdims=True)


def table(scene, n, rng):
    values = np.array(scene.parameters["values"], dtype=float)
    (rows, columns), (x, y) = values.shape, scene.parameters["domain"]
    cumulative = np.cumsum(values)
    cell = np.searchsorted(cumulative / cumulative[-1], uniform(n, rng), side="right")
    row, column = np.divmod(cell, columns)
    along, across = (column + rng.random(n)) / columns, (row + rng.random(n)) / rows
    return np.column_stack([x[0] + (x[1] - x[0]) * along, y[0] + (y[1] - y[0]) * across])


def mean(scene, n, rng):
    """Estimates of 1/3: u^2."""
    return uniform(n, rng) ** 2


freepath.serve(density=ramp, discrete=search, direction=cosine, table_2d=table, estimate=mean)
