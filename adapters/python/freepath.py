"""Turns a vectorised sampler into a subject of freepath. Needs NumPy alone; copy this file to where yours is.

    import freepath

    def tracker(medium, n, rng):        # n free paths, infinity for an escape
        ...

    freepath.serve(free_path=tracker)

`freepath run --allow-commands` starts the program, tells it on standard input what to draw and reads doubles from standard
output. So take every random number from `rng`, and nothing from the clock.

    medium.mu(t)        extinction at t (an array), 1/length
    medium.length       length of the ray
    medium.majorants    upper bounds of mu: `ends` and `mu_bar`, arrays with an entry per segment
    medium.sigma_t      of a chromatic medium: extinction and scattering of each channel, arrays
    medium.sigma_s
    medium.parameters   the medium as the case has it
"""

import ast
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
        self.sigma_t, self.sigma_s = _channels(self.parameters)
        self.mu = _table(request["table"], request["rows_per_cell"]) if "table" in request else _mu(self.parameters)


def _channels(medium):
    """Extinction and scattering of each channel, if the medium has channels."""
    (name, p), = medium.items()
    if name == "chromatic":
        return np.array(p["sigma_t"], dtype=float), np.array(p["sigma_s"], dtype=float)
    if "medium" not in p:
        return None, None
    by, (sigma_t, sigma_s) = p["by"] if name == "scaled" else 1.0, _channels(p["medium"])
    return (sigma_t, sigma_s) if sigma_t is None else (by * sigma_t, by * sigma_s)


def _length(medium):
    (name, p), = medium.items()
    if name in ("scaled", "reversed"):
        return _length(p["medium"])
    return p["to"] - p["from"] if name == "segment" else p["length"]


def _mu(medium):
    """mu(t) in closed form; media that are polynomials between breaks come as a table."""
    (name, p), = medium.items()
    if name == "gaussian":
        return _curve(lambda t: p.get("base", 0.0) + p["peak"] * np.exp(-0.5 * ((t - p["center"]) / p["width"]) ** 2))
    if name == "exponential":
        return _curve(lambda t: p["mu0"] * np.exp(-t / p["scale_height"]))
    if name == "sinusoid":
        turns = lambda t: 2.0 * np.pi * p["frequency"] * t + p.get("phase", 0.0)
        return _curve(lambda t: p["mean"] * (1.0 + p["amplitude"] * np.sin(turns(t))))
    if name == "formula":
        formula = ast.parse(f"({p['mu'].replace('^', '**')})", mode="eval").body
        return _curve(lambda t: _value(formula, t) + np.zeros_like(t))
    if name in ("scaled", "reversed", "segment"):
        inner, length = _mu(p["medium"]), _length(medium)
        if name == "scaled":
            return _curve(lambda t: p["by"] * inner(t))
        return _curve(lambda t: inner(length - t if name == "reversed" else p["from"] + t))
    return _curve(lambda t: _unknown(name))


def _curve(mu):
    return lambda t: mu(np.asarray(t, dtype=float))


def _unknown(name):
    raise NotImplementedError(f"freepath.py does not know mu(t) of the medium {name!r}: write it yourself")


FUNCTIONS = {
    ast.Add: np.add, ast.Sub: np.subtract, ast.Mult: np.multiply, ast.Div: np.divide, ast.Pow: np.power,
    ast.USub: np.negative, ast.UAdd: np.positive,
    "abs": np.abs, "sqrt": np.sqrt, "exp": np.exp, "ln": np.log, "log10": np.log10, "sin": np.sin, "cos": np.cos,
    "tan": np.tan, "asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "sinh": np.sinh, "cosh": np.cosh,
    "tanh": np.tanh, "floor": np.floor, "min": np.minimum, "max": np.maximum,
    "step": lambda a, t: np.where(t < a, 0.0, 1.0),
}


def _value(node, t):
    """The value of a formula at t."""
    if isinstance(node, ast.Constant):
        return np.float64(node.value)
    if isinstance(node, ast.Name):
        return {"t": t, "pi": np.pi}[node.id]
    if isinstance(node, ast.UnaryOp):
        return FUNCTIONS[type(node.op)](_value(node.operand, t))
    if isinstance(node, ast.BinOp):
        return FUNCTIONS[type(node.op)](_value(node.left, t), _value(node.right, t))
    return FUNCTIONS[node.func.id](*(_value(argument, t) for argument in node.args))


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
    What it prints goes to standard error.
    """
    output, sys.stdout = sys.stdout.buffer, sys.stderr
    request = json.loads(sys.stdin.readline())
    if request["protocol"] != PROTOCOL:
        sys.exit(f"freepath.py speaks protocol {PROTOCOL}, not {request['protocol']}")
    kind, left = request["kind"], request["draws"]
    sampler = samplers.get(kind)
    if sampler is None:
        sys.exit(f"there is no sampler of the kind {kind!r}: freepath.serve({kind}=..)")
    medium, rng = Medium(request), np.random.default_rng(request["seed"])
    row = (2 + len(medium.sigma_t),) if kind == "chromatic" else ()
    while left > 0:
        n = min(left, ROWS_AT_A_TIME)
        draws = np.ascontiguousarray(sampler(medium, n, rng), dtype="<f8")
        if draws.shape != (n, *row):
            sys.exit(f"the sampler gave an array of the shape {draws.shape}, not {(n, *row)}")
        output.write(draws.tobytes())
        left -= n
    output.flush()
