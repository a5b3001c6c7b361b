"""Turns a vectorised sampler into a subject of freepath. Needs NumPy alone; copy this file to where yours is.

    import freepath

    def tracker(medium, n, rng):        # n free paths, infinity for an escape
        ...

    freepath.serve(free_path=tracker)

`freepath run --allow-commands` starts the program, tells it on standard input what to draw and reads doubles from standard
output. So take every random number from `rng`, and nothing from the clock.

    medium.mu(t)        extinction at t, 0 <= t <= length (an array), in 1/length
    medium.length       length of the ray
    medium.majorants    upper bounds of mu: `ends` and `mu_bar`, arrays with an entry per segment
    medium.sigma_t      of a chromatic medium, in the place of mu: extinction and scattering of each channel, arrays
    medium.sigma_s
    medium.name, medium.parameters   the medium as the case has it

A case with a `scene` in the place of a medium gives that, by its `name` and `parameters`, and a row of several columns is an array:

    def cosine(scene, n, rng):          # n directions about scene.parameters["normal"]: an array of n rows x, y, z
        ...

    freepath.serve(direction=cosine)
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


class Scene:
    """The scene as the case has it: what it is called, and its parameters."""

    def __init__(self, request):
        self.name, self.parameters = next(iter(request["medium"].items()))


class Medium(Scene):
    """The extinction along the ray."""

    def __init__(self, request):
        super().__init__(request)
        self.length = float(request["length"])
        self.majorants = Majorants(request["majorants"])
        if "sigma_t" in request:
            self.sigma_t, self.sigma_s = np.array(request["sigma_t"]), np.array(request["sigma_s"])
        else:
            self.mu = _table(request["table"], request["rows_per_cell"])


def _table(path, rows_per_cell):
    """The polynomial through the rows of each cell, by Newton's forward differences over their factorials."""
    rows = np.loadtxt(path, delimiter=",", skiprows=1).reshape(-1, rows_per_cell, 2)
    t, terms = rows.transpose(2, 1, 0).copy()
    starts, steps = t[0], (t[-1] - t[0]) / (rows_per_cell - 1)
    for order in range(1, rows_per_cell):
        terms[order:] = np.diff(terms[order - 1:], axis=0) / order

    def at(x):
        x = np.asarray(x, dtype=float)
        cell = np.clip(np.searchsorted(starts, x, side="right") - 1, 0, len(starts) - 1)
        s, total = (x - starts[cell]) / steps[cell], 0.0
        for k in reversed(range(rows_per_cell)):
            total = total * (s - k) + terms[k][cell]
        return np.maximum(total, 0.0)  # rounding takes it below

    return at


def serve(**samplers):
    """Answers one request: `free_path`, `transmittance`, `chromatic`, `density`, `direction` .. is a function f(medium, n, rng).

    It gives n numbers, or an array of n rows where a row has several columns: of `direction` x, y, z; of `table_2d` x, y; of
    `chromatic` t, event (0 scatters, 1 is the surface), one weight per channel. What it prints goes to standard error.
    """
    output, sys.stdout = sys.stdout.buffer, sys.stderr
    request = json.loads(sys.stdin.readline())
    if request["protocol"] != PROTOCOL:
        sys.exit(f"freepath.py speaks protocol {PROTOCOL}, not {request['protocol']}")
    kind, left = request["kind"], request["draws"]
    sampler = samplers.get(kind)
    if sampler is None:
        sys.exit(f"there is no sampler of the kind {kind!r}: freepath.serve({kind}=..)")
    along_a_ray = "table" in request or "sigma_t" in request
    medium, rng = (Medium if along_a_ray else Scene)(request), np.random.default_rng(request["seed"])
    columns = request["columns"]
    row = (len(columns),) if len(columns) > 1 else ()
    while left > 0:
        n = min(left, ROWS_AT_A_TIME)
        draws = np.ascontiguousarray(sampler(medium, n, rng), dtype="<f8")
        if draws.shape != (n, *row):
            sys.exit(f"the sampler gave an array of the shape {draws.shape}, not {(n, *row)}: {', '.join(columns)}")
        output.write(draws.tobytes())
        left -= n
    output.flush()
