"""Law: the effort of a driver is the rate of potential energy if the machine is at rest, and the
rate of the total energy if it moves, per unit of the driver's coordinate.

A driven six-bar with masses, a straight spring and a torsion spring is placed by `assur solve`; its
energies are computed here from the places and velocities of its links, and their rates by central
differences.
"""

import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

SEED = 11
SCENES = 12
STEP = 1e-4  # of the crank's angle, and of time
BOUND = 1e-6  # of the larger of one and the rate; differences leave 1e-7 and less


class Machine:
    """A crank AB, a coupler BCE, a rocker DC, and a rod ES to a block on a slide ST."""

    def __init__(self, numbers):
        def between(low, high):
            return round(numbers.uniform(low, high), 3)

        self.points = {
            "A": [0, 0],
            "B": [between(-1, 1), between(0.3, 1)],
            "C": [between(2, 3), between(1, 2)],
            "D": [between(2.5, 3.5), between(-0.3, 0.3)],
            "E": [between(1, 2), between(2, 3)],
            "S": [between(4, 5), between(1, 2)],
            "T": [between(5, 6), between(1, 2)],
        }
        self.points["Q"] = list(self.points["S"])
        self.gravity = [between(-1, 1), -9.81]
        self.masses = {
            link: (between(1, 3), [between(0, 1), between(-1, 1)], between(0, 1))
            for link in ("crank", "coupler", "rod", "block")
        }
        self.stiffness, self.length = between(5, 20), between(0.2, 1)
        self.torsion, self.rest = between(1, 4), between(-0.5, 0.5)

    def scene(self, turn, velocity=0.0, acceleration=0.0):
        return {
            "parameters": {"start": {"drawn": "A"}},
            "points": self.points,
            "links": {
                "ground": ["A", "D", "Q", "T"],
                "crank": ["A", "B"],
                "coupler": ["B", "C", "E"],
                "rocker": ["D", "C"],
                "rod": ["E", "S"],
                "block": ["S"],
            },
            "joints": {"way": {"type": "prismatic", "links": ["ground", "block"], "along": ["Q", "T"]}},
            "drivers": {
                "A": {
                    "position": f"start + {turn!r}",
                    "velocity": velocity,
                    "acceleration": acceleration,
                }
            },
            "masses": {
                link: {"mass": mass, "at": at, "inertia": inertia}
                for link, (mass, at, inertia) in self.masses.items()
            },
            "gravity": self.gravity,
            "springs": {
                "straight": {
                    "between": ["ground.T", "coupler.E"],
                    "stiffness": self.stiffness,
                    "length": self.length,
                },
                "torsion": {"joint": "D", "stiffness": self.torsion, "rest": self.rest},
            },
            "want": ["position", "velocity", "acceleration", "forces"],
        }

    def own_place(self, point, origin, second):
        """A drawn point in the frame of a link with its origin at one point, its x-axis toward a second."""
        (ox, oy), (sx, sy), (px, py) = (self.points[name] for name in (origin, second, point))
        length = math.hypot(sx - ox, sy - oy)
        c, s = (sx - ox) / length, (sy - oy) / length
        return [c * (px - ox) + s * (py - oy), c * (py - oy) - s * (px - ox)]

    def potential(self, links):
        energy = 0.0
        for link, (mass, at, _) in self.masses.items():
            x, y = placed(links[link], at)
            energy -= mass * (self.gravity[0] * x + self.gravity[1] * y)
        x, y = placed(links["coupler"], self.own_place("E", "B", "C"))
        stretch = math.hypot(x - self.points["T"][0], y - self.points["T"][1]) - self.length
        twist = math.remainder(links["rocker"]["theta"] - self.rest, 2 * math.pi)
        return energy + (self.stiffness * stretch**2 + self.torsion * twist**2) / 2

    def kinetic(self, links):
        energy = 0.0
        for link, (mass, at, inertia) in self.masses.items():
            vx, vy, omega = links[link]["velocity"]
            x, y = placed(links[link], at)
            rx, ry = x - links[link]["x"], y - links[link]["y"]
            energy += (mass * ((vx - omega * ry) ** 2 + (vy + omega * rx) ** 2) + inertia * omega**2) / 2
        return energy


def placed(link, at):
    c, s = math.cos(link["theta"]), math.sin(link["theta"])
    return link["x"] + c * at[0] - s * at[1], link["y"] + s * at[0] + c * at[1]


def main():
    numbers = random.Random(SEED)
    largest = {"at rest": 0.0, "in motion": 0.0}
    with tempfile.TemporaryDirectory() as directory:
        file = pathlib.Path(directory, "scene.json")

        def drawn(scene):
            file.write_text(json.dumps(scene))
            answer = subprocess.run(
                [sys.argv[1], "solve", file, "--format", "json"], capture_output=True, text=True, check=True
            )
            solved = json.loads(answer.stdout)
            return solved["configurations"][solved["drawn"]["configuration"] - 1]

        for _ in range(SCENES):
            machine = Machine(numbers)

            def compare(what, told, rate):
                largest[what] = max(largest[what], abs(told - rate) / max(1, abs(rate)))

            still = drawn(machine.scene(0.0))
            beside = [machine.potential(drawn(machine.scene(turn))["links"]) for turn in (-STEP, STEP)]
            compare("at rest", still["drivers"]["A"]["effort"], (beside[1] - beside[0]) / (2 * STEP))
            speed, gain = 1.5, 0.7
            moving = drawn(machine.scene(0.0, speed, gain))
            energies = []
            for time in (-STEP, STEP):
                turn = speed * time + gain * time**2 / 2
                links = drawn(machine.scene(turn, speed + gain * time, gain))["links"]
                energies.append(machine.kinetic(links) + machine.potential(links))
            power = (energies[1] - energies[0]) / (2 * STEP)
            compare("in motion", moving["drivers"]["A"]["effort"] * speed, power)
    print(f"seed {SEED}, {SCENES} machines:", largest)
    sys.exit(max(largest.values()) > BOUND)


main()
