"""Law: threads that share a plan get, bit for bit, what one thread gets, whatever else runs."""

import pickle
import subprocess
import sys
import threading

import numpy as np
import pytest

import assur

PHI = np.linspace(0, 6, 60)
# With a coupler of 20 some of the links cannot reach.
COUPLER = np.where(np.arange(60) % 3 == 0, 20.0, 100.0)

# Every entry that runs without the interpreter's lock.
CALLS = {
    "read_scene": lambda file, plan: assur.read_scene(file, phi="1/2", crank=38).parameters,
    "parse_scene": lambda file, plan: assur.parse_scene(file.read_text(), crank=38).svg(),
    "Plan": lambda file, plan: assur.Plan(plan.scene).solve(),
    "solve": lambda file, plan: plan.solve(phi=0.7),
    "solve_one": lambda file, plan: plan.solve_one(2, {"phi": 0.8}),
    "solve_nearest": lambda file, plan: plan.solve_nearest(phi=0.9),
    "solve_batch": lambda file, plan: plan.solve_batch(phi=PHI, coupler=COUPLER, crank=38),
    "solve_batch, steps": lambda file, plan: plan.solve_batch(phi=np.repeat(PHI, 2)[::-2]),
    "solve_batch, following": lambda file, plan: plan.solve_batch(phi=PHI, coupler=COUPLER,
                                                                  branch=2),
    "sweep": lambda file, plan: plan.sweep(crank=38),
    "sweep, items": lambda file, plan: plan.sweep(phi=PHI, coupler=COUPLER),
    "sweep_branch": lambda file, plan: plan.sweep_branch(1, crank=38),
    "sample": lambda file, plan: assur.sample(plan.scene, 600, 1, threads=2),
    "sample, normal": lambda file, plan: assur.sample(plan.scene, 600, 1, deviations="normal",
                                                      crank=38),
    "pickle": lambda file, plan: pickle.loads(pickle.dumps(plan.sweep())),
    "Solution.reason": lambda file, plan: plan.solve(coupler=20).reason,
    "Solution.to_json": lambda file, plan: plan.solve().to_json(),
    "str(Solution)": lambda file, plan: str(plan.solve()),
    "Solution.svg": lambda file, plan: plan.solve(phi=1).svg(),
    "Configuration.svg": lambda file, plan: plan.solve(phi=1)[1].svg(),
    "Scene.svg": lambda file, plan: plan.scene.svg(),
    "Scene.moving_svg": lambda file, plan: plan.scene.moving_svg(),
    "Scene.dxf": lambda file, plan: plan.scene.dxf(2),
    "Scene.page": lambda file, plan: plan.scene.page(),
}
# What these refuse is thrown without the lock.
REFUSED = {
    "read_scene": lambda file, plan: assur.read_scene(file.with_suffix(".gone")),
    "parse_scene": lambda file, plan: assur.parse_scene(file.read_text(), crank="cranc"),
    "Plan": lambda file, plan: assur.Plan(assur.parse_scene({"drivers": {}})),
    "solve": lambda file, plan: plan.solve(phi=float("nan")),
    "solve_one": lambda file, plan: plan.solve_one(9),
    "solve_batch": lambda file, plan: plan.solve_batch(phi=[*PHI, np.inf]),
    "sweep": lambda file, plan: plan.sweep(phi=1),
    "sweep_branch": lambda file, plan: plan.sweep_branch(9),
    "sample": lambda file, plan: assur.sample(plan.scene, 600, 1, branch=9),
    "Scene.svg": lambda file, plan: plan.scene.svg(9),
    "Scene.moving_svg": lambda file, plan: plan.scene.moving_svg(9),
    "Scene.dxf": lambda file, plan: plan.scene.dxf(9),
}


def told(result):
    """All that a result holds, as something that `==` compares bit for bit."""
    if isinstance(result, np.ndarray):
        return result.dtype.str, result.shape, result.tobytes()
    if isinstance(result, assur.Sweep):
        return told([result.parameter, result.branches, result.unassigned, result.events])
    if isinstance(result, dict):
        return [(name, told(part)) for name, part in result.items()]
    if isinstance(result, (list, tuple)):
        return [told(part) for part in result]
    if type(result).__module__.startswith("assur") and not isinstance(result, int):
        numbers = []
        for name in dir(type(result)):
            if isinstance(getattr(type(result), name), property) and hasattr(result, name):
                numbers.append((name, told(getattr(result, name))))
        return numbers + ([told(result.items())] if hasattr(result, "items") else [])
    return float(result).hex() if isinstance(result, float) else repr(result)


def outcome(call, *arguments):
    try:
        return told(call(*arguments))
    except assur.Error as error:
        return type(error).__name__, str(error)


@pytest.fixture
def often():
    """Threads take turns as often as they can."""
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    yield
    sys.setswitchinterval(interval)


def expect_the_same_in_threads(call, file, plan):
    alone = outcome(call, file, plan)
    done = threading.Event()
    found = []

    def ask():
        for _ in range(4):
            found.append(outcome(call, file, plan))

    def make_objects():
        while not done.is_set():
            [str(number) for number in range(1000)]

    busy = threading.Thread(target=make_objects)
    askers = [threading.Thread(target=ask) for _ in range(3)]
    for thread in (busy, *askers):
        thread.start()
    for thread in askers:
        thread.join()
    done.set()
    busy.join()
    assert len(found) == 12 and all(one == alone for one in found)
    return alone


@pytest.fixture
def scene(command, example):
    file = command.file(example("four_bar_coupler_curve", steps=15, reference={"coupler": 1}))
    return file, assur.Plan(assur.read_scene(file))


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_results(scene, often, call):
    assert expect_the_same_in_threads(call, *scene)


@pytest.mark.parametrize("call", REFUSED.values(), ids=REFUSED)
def test_refusals(scene, often, call):
    name, line = expect_the_same_in_threads(call, *scene)
    assert name == "SceneError" and "\n" not in line


def expect_quiet_end(program, *arguments):
    ended = subprocess.run([sys.executable, "-c", program, *map(str, arguments)],
                           capture_output=True, text=True, check=False, timeout=60)
    assert (ended.returncode, ended.stderr) == (0, "")


FIRST_CALLS = """
import sys, threading
import assur
sys.setswitchinterval(1e-6)
plan = assur.Plan(assur.read_scene(sys.argv[1]))
threads = [threading.Thread(target=plan.solve_batch, kwargs={"phi": [1.0]}) for _ in range(4)]
[thread.start() for thread in threads]
[thread.join() for thread in threads]
"""


def test_the_first_calls_of_a_process(scene):
    for _ in range(3):
        expect_quiet_end(FIRST_CALLS, scene[0])


ENDS_WHILE = """
import sys, threading, time
import assur
plan = assur.Plan(assur.read_scene(sys.argv[1]))
calls = {"sweep": plan.sweep, "solve_batch": lambda: plan.solve_batch(phi=[1.0] * 100_000),
         "sample": lambda: assur.sample(plan.scene, 10**8, 1, threads=1)}
def ask():
    while True:
        calls[sys.argv[2]]()
for _ in range(2):
    threading.Thread(target=ask, daemon=True).start()
time.sleep(0.2)
"""


@pytest.mark.parametrize("call", ["solve_batch", "sweep", "sample"])
def test_the_interpreter_ends_while_daemons_solve(scene, call):
    expect_quiet_end(ENDS_WHILE, scene[0], call)
