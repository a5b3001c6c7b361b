#!/usr/bin/env python3
"""Draws free paths with programs that nobody here wrote, and the case files that judge them.

Without names, every program that is installed. The README beside this file says how to install each.
"""

import argparse
import importlib.util
import json
import math
import random
import sys
from pathlib import Path

import numpy as np

CASES = Path(__file__).resolve().parent.parent
SEED = 20261122


def case(out, name, title, medium, subjects):
    """Writes a case; each subject is (kind, name, file), and the reason for which it must fail, if it must."""

    def subject(kind, label, file, reason=None):
        return {kind: {"samples": {"file": file}}, "name": label} | ({"expect": {"fail": reason}} if reason else {})

    listed = [subject(*s) for s in subjects]
    body = {"title": title, "medium": medium, "subjects": listed}
    (out / f"{name}.json").write_text(json.dumps(body, indent=2) + "\n")


# ---------------------------------------------------------------------------------------------------- NumPy and SciPy

MU, LENGTH = 1.3, 1.9


def escaped(t, length):
    return np.where(t < length, t, np.inf)


def delta_tracking(mu, majorant, length, n, rng):
    """Woodcock's walk, written from this project's README alone: all walks of a tile step together."""
    t = np.zeros(n)
    flying = np.arange(n)
    while flying.size:
        t[flying] -= np.log1p(-rng.random(flying.size)) / majorant
        t[flying[t[flying] >= length]] = np.inf
        flying = flying[np.isfinite(t[flying])]
        flying = flying[rng.random(flying.size) * majorant >= mu(t[flying])]
    return t


def draw_numpy(out, n):
    rng = np.random.default_rng(SEED)
    np.save(out / "numpy_exponential.npy", escaped(rng.exponential(1 / MU, n), LENGTH))
    np.save(out / "numpy_exponential_f32.npy", escaped(rng.standard_exponential(n, np.float32) / np.float32(MU), LENGTH).astype("f4"))
    homogeneous = {"constant": {"mu": MU, "length": LENGTH}}
    files = [("free_path", "numpy exponential", "numpy_exponential.npy"),
             ("free_path", "numpy exponential f32", "numpy_exponential_f32.npy")]
    case(out, "numpy_homogeneous", "NumPy's exponentials", homogeneous, files)
    bump = lambda t: 0.2 + 4.0 * np.exp(-((t - 0.9) / 0.25) ** 2 / 2)
    np.save(out / "numpy_delta.npy", delta_tracking(bump, 4.2, 2.3, n, rng))
    wrong = lambda t: bump(np.maximum(t - 0.03, 0.0))
    np.save(out / "numpy_delta_late.npy", delta_tracking(wrong, 4.2, 2.3, n, rng))
    medium = {"gaussian": {"peak": 4.0, "center": 0.9, "width": 0.25, "length": 2.3, "base": 0.2}}
    files = [("free_path", "delta tracking of 10 lines", "numpy_delta.npy"),
             ("free_path", "the same, looking up 0.03 late", "numpy_delta_late.npy", "wrong_law")]
    case(out, "numpy_delta_tracking", "Delta tracking in NumPy", medium, files)


def draw_scipy(out, n):
    from scipy import stats

    rng = np.random.default_rng(SEED + 1)
    np.save(out / "scipy_expon.npy", escaped(stats.expon.rvs(scale=1 / MU, size=n, random_state=rng), LENGTH))
    inverse = stats.expon.ppf(rng.random(n), scale=1 / MU)
    np.save(out / "scipy_expon_ppf.npy", escaped(inverse, LENGTH))
    files = [("free_path", "scipy expon.rvs", "scipy_expon.npy"), ("free_path", "scipy expon.ppf", "scipy_expon_ppf.npy")]
    case(out, "scipy_homogeneous", "SciPy's exponentials", {"constant": {"mu": MU, "length": LENGTH}}, files)


# ---------------------------------------------------------------------------------------------------- Mitsuba 3

ORIGIN, DIRECTION = (0.02, 0.31, 0.27), (0.8, 0.45, 0.32)
SCALE = 5.0


def head():
    """The shipped volume, as single precision in [0, 1]."""
    volume = np.load(CASES / "data" / "head_epi_24x96x128_u16.npy").astype("f4")
    return volume / volume.max()


def delta_walk(mi, medium, rng):
    """One free path as Mitsuba's volumetric integrators draw it: tentative distances of the medium, null collisions by the
    ratio of its own coefficients, the ray continued from the point of the collision."""
    origin = mi.Point3f(*ORIGIN)
    direction = mi.Vector3f(*(np.array(DIRECTION) / np.linalg.norm(DIRECTION)))
    ray = mi.Ray3f(origin, direction)
    while True:
        at = medium.sample_interaction(ray, float(rng.random(dtype=np.float32)), 0, True)
        if not at.is_valid():
            return math.inf
        if rng.random(dtype=np.float32) < at.sigma_t[0] / at.combined_extinction[0]:
            gone = at.p - origin
            return gone.x * direction.x + gone.y * direction.y + gone.z * direction.z
        ray.o = at.p


def draw_heterogeneous(mi, out, n):
    volume = head()
    np.save(out / "head_f32.npy", volume)
    rng = np.random.default_rng(SEED + 2)
    for kind in ("nearest", "trilinear"):
        grid = {"type": "gridvolume", "grid": mi.VolumeGrid(volume[..., None]), "filter_type": kind, "raw": True}
        medium = mi.load_dict({"type": "heterogeneous", "albedo": 0.8, "scale": SCALE, "sigma_t": grid})
        t = np.array([delta_walk(mi, medium, rng) for _ in range(n)], dtype="f4")
        np.save(out / f"mitsuba_{kind}.npy", t)
        seen = {"file": "head_f32.npy", "filter": kind, "bounds": [[0, 0, 0], [1, 1, 1]], "scale": SCALE,
                "origin": ORIGIN, "direction": DIRECTION}
        files = [("free_path", f"mitsuba heterogeneous {kind}", f"mitsuba_{kind}.npy")]
        case(out, f"mitsuba_{kind}", f"Mitsuba 3: heterogeneous, {kind}", {"voxel_grid": seen}, files)


SIGMA_T, ALBEDO, CHROMATIC_LENGTH = (0.4, 1.1, 3.0), (0.9, 0.6, 0.3), 1.7


def chromatic_draw(mi, medium, surface, rng):
    """One draw of `volpath`: a channel at random, a distance by it, the weight divided by the density of that channel."""
    channel = min(int(rng.random() * 3), 2)
    ray = mi.Ray3f(mi.Point3f(0, 0, 0), mi.Vector3f(1, 0, 0))
    ray.maxt = CHROMATIC_LENGTH
    at = medium.sample_interaction(ray, float(rng.random(dtype=np.float32)), channel, True)
    transmittance, density = medium.transmittance_eval_pdf(at, surface, True)
    weight = np.array(transmittance) / density[channel]
    if at.is_valid() and at.t < CHROMATIC_LENGTH:
        return [at.t, 0.0, *(weight * np.array(at.sigma_s))]
    return [CHROMATIC_LENGTH, 1.0, *weight]


def draw_chromatic(mi, out, n):
    spectrum = lambda values: {"type": "constvolume", "value": {"type": "rgb", "value": list(values)}}
    # An rgb value above 1 is refused, so that the greatest extinction goes into the scale.
    top = max(SIGMA_T)
    description = {"type": "homogeneous", "albedo": spectrum(ALBEDO), "scale": top, "sigma_t": spectrum(s / top for s in SIGMA_T)}
    medium = mi.load_dict(description)
    surface = mi.SurfaceInteraction3f()
    surface.t = CHROMATIC_LENGTH
    rng = np.random.default_rng(SEED + 3)
    rows = np.array([chromatic_draw(mi, medium, surface, rng) for _ in range(n)], dtype="f4")
    np.save(out / "mitsuba_chromatic.npy", rows)
    sigma_s = [a * s for a, s in zip(ALBEDO, SIGMA_T)]
    seen = {"chromatic": {"sigma_t": SIGMA_T, "sigma_s": sigma_s, "length": CHROMATIC_LENGTH}}
    files = [("chromatic", "mitsuba homogeneous", "mitsuba_chromatic.npy")]
    case(out, "mitsuba_chromatic", "Mitsuba 3: homogeneous, three channels", seen, files)


def draw_mitsuba(out, n):
    import mitsuba as mi

    mi.set_variant("scalar_rgb")
    draw_heterogeneous(mi, out, n)
    draw_chromatic(mi, out, n)


# ---------------------------------------------------------------------------------------------------- pytissueoptics

LAYERS = ((0.3, 0.5), (2.0, 0.6), (0.1, 0.4), (3.0, 0.8))  # extinction, thickness


def draw_pytissueoptics(out, n):
    n = min(n, 98_304)  # some 0.3 ms each
    from pytissueoptics import Cuboid, ScatteringMaterial, Vector
    from pytissueoptics.rayscattering.photon import Photon
    from pytissueoptics.rayscattering.scatteringScene import ScatteringScene
    from pytissueoptics.scene.intersection import FastIntersectionFinder

    class Flight(Photon):
        """A photon whose life ends at its first collision."""

        collided = False

        def scatter(self):
            self.collided, self._weight = True, 0

    tissue = [ScatteringMaterial(mu_s=mu - 0.01, mu_a=0.01, g=0, n=1.0) for mu, _ in LAYERS]
    layers = [Cuboid(a=3, b=3, c=c, material=m, label=f"layer {i}") for i, (m, (_, c)) in enumerate(zip(tissue, LAYERS))]
    stack = layers[0]
    for layer in layers[1:]:
        stack = stack.stack(layer, "back")
    scene = ScatteringScene([stack])
    start, finder = scene.getBoundingBox().zMin, FastIntersectionFinder(scene)
    random.seed(SEED)
    t = np.empty(n)
    for i in range(n):
        photon = Flight(Vector(0.1, 0.2, start - 0.1), Vector(0, 0, 1))
        photon.setContext(scene.getWorldEnvironment(), finder)
        left = 0
        while photon.isAlive:
            left = photon.step(left)
        t[i] = photon.position.z - start if photon.collided else math.inf
    np.save(out / "pytissueoptics.npy", t)
    edges = [0.0, *np.cumsum([c for _, c in LAYERS]).tolist()]
    medium = {"piecewise_constant": {"edges": edges, "values": [mu for mu, _ in LAYERS]}}
    files = [("free_path", "pytissueoptics photon", "pytissueoptics.npy")]
    case(out, "pytissueoptics", "pytissueoptics: a photon through four layers", medium, files)


# ---------------------------------------------------------------------------------------------------- all of them

PROGRAMS = {"numpy": draw_numpy, "scipy": draw_scipy, "mitsuba": draw_mitsuba, "pytissueoptics": draw_pytissueoptics}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path, help="the folder of the samples and cases")
    parser.add_argument("programs", nargs="*", metavar="program", help=f"one of {', '.join(PROGRAMS)}")
    parser.add_argument("--draws", type=int, default=1_000_000, help="draws of each; of pytissueoptics at most 98,304")
    args = parser.parse_args()
    unknown = set(args.programs) - set(PROGRAMS)
    if unknown:
        parser.error(f"unknown program {', '.join(sorted(unknown))} (one of {', '.join(PROGRAMS)})")
    args.out.mkdir(parents=True, exist_ok=True)
    for name in args.programs or PROGRAMS:
        if not args.programs and importlib.util.find_spec(name) is None:
            print(f"LEFT OUT: {name} is not installed (pip install {name})", file=sys.stderr)
            continue
        print(f"drawing with {name}", file=sys.stderr)
        PROGRAMS[name](args.out, args.draws)


if __name__ == "__main__":
    main()
