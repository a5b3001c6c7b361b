"""Turns a vectorised sampler into a subject of freepath. Needs NumPy alone; copy this file to where yours is.

    import freepath

    def tracker(medium, n, rng):        # n free paths, infinity for an escape
        ...

    freepath.serve(free_path=tracker)

`freepath run --allow-commands` starts the program, tells it on standard input what to draw and reads doubles from standard
output. So print to standard error, take every random number from `rng`, and nothing from the clock.

    medium.mu(t)        extinction at t (an array), 1/length
    medium.length       length of the ray
    medium.majorants    upper bounds of mu: `ends` and `mu_bar`, arrays with an entry per segment
    medium.parameters   the medium as the case has it
"""

import json
import sys

import numpy as np

PROTOCOL = 1
ROWS_AT_A_TIME = 65536


class Majorants:
    """In segment k, up to ends[k], mu is at most mu_bar[k]."""

    def __init__(self, segments):
        self.ends = np.array([segment["end"] for segment in segments], dtype=float)
        self.mu_bar = np.array([segment["mu_bar"] for segment in segments], dtype=float)

    def at(self, t):
        """The bound at t."""
        return self.mu_bar[np.minimum(np.searchsorted(self.ends, t, side="right"), len(self.ends) - 1)]


class Medium:
    """The extinction along the ray."""

    def __init__(self, request):
        self.parameters = request["medium"]
        self.length = float(request["length"])
        self.majorants = Majorants(request["majorants"])
        (self.name, self._is), = self.parameters.items()
        if "table" in request:
            self.mu = _table(request["table"], request["rows_per_cell"])

    def mu(self, t):
        """mu(t)."""
        t, p = np.asarray(t, dtype=float), self._is
        if self.name == "gaussian":
            return p.get("base", 0.0) + p["peak"] * np.exp(-0.5 * ((t - p["center"]) / p["width"]) ** 2)
        if self.name == "exponential":
            return p["mu0"] * np.exp(-t / p["scale_height"])
        raise NotImplementedError(f"freepath.py does not know mu(t) of the medium {self.name!r}: write it yourself")


def _table(path, rows_per_cell):
    """mu through the nodes of each cell: Lagrange's polynomial."""
    t, mu = np.loadtxt(path, delimiter=",", skiprows=1, ndmin=2).reshape(-1, rows_per_cell, 2).transpose(2, 0, 1)
    starts, widths = t[:, 0], t[:, -1] - t[:, 0]
    nodes = np.linspace(0.0, 1.0, rows_per_cell)

    def at(x):
        x = np.asarray(x, dtype=float)
        cell = np.clip(np.searchsorted(starts, x, side="right") - 1, 0, len(starts) - 1)
        u = (x - starts[cell]) / widths[cell]
        total = np.zeros_like(u)
        for k in range(rows_per_cell):
            weight = np.ones_like(u)
            for j in range(rows_per_cell):
                if j != k:
                    weight = weight * (u - nodes[j]) / (nodes[k] - nodes[j])
            total = total + weight * mu[cell, k]
        return total

    return at


def serve(**samplers):
    """Answers one request: `free_path`, `transmittance` or `chromatic` is a function f(medium, n, rng).

    It gives n numbers; for `chromatic` an array of n rows t, event (0 scatters, 1 is the surface), one weight per channel.
    """
    request = json.loads(sys.stdin.readline())
    if request["protocol"] != PROTOCOL:
        sys.exit(f"freepath.py speaks protocol {PROTOCOL}, not {request['protocol']}")
    sampler = samplers.get(request["kind"])
    if sampler is None:
        sys.exit(f"there is no sampler of the kind {request['kind']!r}: freepath.serve({request['kind']}=..)")
    medium, rng, left = Medium(request), np.random.default_rng(request["seed"]), request["draws"]
    while left > 0:
        n = min(left, ROWS_AT_A_TIME)
        draws = np.asarray(sampler(medium, n, rng), dtype="<f8")
        if len(draws) != n:
            sys.exit(f"the sampler gave {len(draws)} draws, not {n}")
        sys.stdout.buffer.write(np.ascontiguousarray(draws).tobytes())
        left -= n
    sys.stdout.buffer.flush()
