"""Law: a call from Python costs less than 10 microseconds beyond what is solved in it, a batch that
follows a branch at most 1.3 times one that does not, and the import less than 0.2 seconds."""

import os
import pathlib
import subprocess
import sys
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


def test_a_batch_that_follows():
    """In steps of a degree; coarser ones are halved until each is clear, and take longer."""
    plan = assur.Plan(assur.read_scene(FOUR_BAR))
    angles = np.radians(np.arange(360.0))
    ratios = []
    for _ in range(5):  # of a pair of times: a busy machine slows both down
        whole = least(lambda: plan.solve_batch(phi=angles), 40)
        ratios.append(least(lambda: plan.solve_batch(phi=angles, branch=1), 40) / whole)
    print(f"\nratios {' '.join(f'{one:.2f}' for one in sorted(ratios))}, "
          f"{1e6 * whole / len(angles):.1f} us an item that does not follow")
    assert min(ratios) < 1.3


def test_the_import():
    """In processor time, since other programs run beside it; nine tenths of it are NumPy's."""
    program = "import time; start = time.process_time(); import assur; print(time.process_time() - start)"
    times = [float(subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                                  check=True).stdout) for _ in range(8)]
    print(f"\nimport assur: {min(times):.3f} s")
    assert min(times) < 0.2
