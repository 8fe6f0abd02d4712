"""Law: a call from Python costs less than 10 microseconds beyond what is solved in it."""

import os
import pathlib
import time

import numpy as np

import assur

FOUR_BAR = pathlib.Path(os.environ["ASSUR_SOURCE"]) / "examples/four_bar_coupler_curve.json"


def least(call, repeats):
    """The least time of a call in seconds: what a busy machine adds is left out."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return min(times)


def test_a_four_bar_with_everything():
    plan = assur.Plan(assur.read_scene(FOUR_BAR))
    angles = np.full(50, 1.0)
    item = least(lambda: plan.solve_batch(phi=angles), 2000) / len(angles)
    call = least(lambda: plan.solve(phi=1.0), 50_000)
    read = least(lambda: plan.solve(phi=1.0)[0].outputs["P"].position, 50_000)
    print(f"\nan item of a batch {1e6 * item:.1f} us, a call {1e6 * call:.1f} us, "
          f"with one array read {1e6 * read:.1f} us")
    # An item holds the solver and what it writes into rows.
    assert call - item < 10e-6
