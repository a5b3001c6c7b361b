"""Writes the extinction at the distances in a file to another: mu.py FROM TO. It draws nothing."""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "python"))
import freepath


def look_up(medium, n, rng):
    np.savetxt(sys.argv[2], medium.mu(np.loadtxt(sys.argv[1])), fmt="%.17g")
    sys.exit(3)


freepath.serve(free_path=look_up)
