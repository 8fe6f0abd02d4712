"""Law: a long call lets other threads run, and ends soon after Ctrl-C."""

import os
import signal
import threading
import time

import numpy as np
import pytest

import assur


@pytest.mark.parametrize("call", [
    lambda plan: plan.solve_batch(phi=np.linspace(0, 6, 2_000_000)),
    lambda plan: plan.sweep(),
    lambda plan: plan.sweep_branch(1),
    lambda plan: assur.sample(plan.scene, 5_000_000, 1, threads=1),
], ids=["solve_batch", "sweep", "sweep_branch", "sample"])
def test_is_interrupted(example, call):
    # Each call takes more than two seconds of processor time. The timer is a thread of Python: it
    # fires only if the call releases the lock.
    scene = example("four_bar_coupler_curve", steps=1_000_000, want=["position"],
                    report={"links": [], "joints": []})
    plan = assur.Plan(assur.parse_scene(scene))
    interruption = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
    start = time.process_time()
    interruption.start()
    with pytest.raises(KeyboardInterrupt):
        call(plan)
    interruption.join()
    assert time.process_time() - start < 1.2
    assert len(plan.solve()) == 2
