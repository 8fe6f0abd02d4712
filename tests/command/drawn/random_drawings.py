"""Makes random drawn scenes: mechanisms whose joints all close in the drawing.

A scene begins with cranks on the ground. Then groups are added, each of which has as many
constraints as freedoms: two bars, a bar and a slider, a bar whose end slides on another link, a
cylinder, a block that two slides hold. Points are drawn from a lattice in half of the scenes, so
that parts are equal, parallel or in line.
"""

import random


class RandomDrawing:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.on_lattice = seed % 2 == 0
        self.points = {}
        self.links = {"ground": []}
        self.joints = {}
        self.drivers = {}
        self.parameters = {}
        self.has_velocities = self.random.random() < 0.8

    # ---- parts ----

    def place(self):
        if self.on_lattice:
            return [self.random.randint(-9, 9), self.random.randint(-9, 9)]
        return [round(self.random.uniform(-9, 9), 3), round(self.random.uniform(-9, 9), 3)]

    def new_point(self):
        name = f"P{len(self.points)}"
        while True:
            place = self.place()
            if place not in self.points.values():
                self.points[name] = place
                return name

    def new_link(self, *points):
        name = self.random.choice("abcxyz") + str(len(self.links))
        self.links[name] = list(points)
        return name

    def new_joint(self, kind, **entries):
        name = f"J{len(self.joints)}"
        self.joints[name] = {"type": kind, **entries}
        return name

    def pin_on(self, link):
        """A point of a link, an old one or a new one."""
        free = [point for point in self.links[link] if point not in self.drivers]
        if free and self.random.random() < 0.4:
            return self.random.choice(free)
        self.links[link].append(self.new_point())
        return self.links[link][-1]

    def some_link(self, *others):
        return self.random.choice([link for link in self.links if link not in others])

    def line(self):
        """What says a line: two points, which exist or are only helpers, or a direction."""
        if self.random.random() < 0.3:
            while True:
                direction = self.place()
                if any(direction):
                    return {"direction": direction}
        points = self.random.sample(list(self.points), 1) + [self.new_point()]
        self.random.shuffle(points)
        return {"along": points}

    def two_pins(self):
        """Points of two different links."""
        while True:
            first = self.some_link()
            second = self.some_link(first)
            one, other = self.pin_on(first), self.pin_on(second)
            if one != other and self.points[one] != self.points[other]:
                return one, other

    # ---- groups ----

    def add_crank(self):
        pin = self.pin_on("ground")
        crank = self.new_link(pin, self.new_point())
        names = [link for link in self.links if pin in self.links[link]]
        joint = pin
        if len(names) > 2 or self.random.random() < 0.3:
            joint = self.new_joint("revolute", links=["ground", crank], at=pin)
        self.drive(joint)

    def drive(self, joint):
        driver = {}
        if self.random.random() < 0.5:
            parameter = f"phi{len(self.parameters)}"
            self.parameters[parameter] = {"drawn": joint}
            driver["position"] = parameter
        if self.has_velocities:
            driver["velocity"] = self.random.randint(-3, 3)
        self.drivers[joint] = driver

    def add_bars(self):
        one, other = self.two_pins()
        middle = self.new_point()
        for end in (one, other):
            points = [end, middle] + [self.new_point() for _ in range(self.random.randint(0, 1))]
            self.random.shuffle(points)
            self.new_link(*points)

    def add_slider(self):
        end = self.pin_on(self.some_link())
        middle = self.new_point()
        self.new_link(end, middle)
        base = self.some_link(list(self.links)[-1])
        slider = self.new_link(middle)
        links = [base, slider]
        self.random.shuffle(links)
        line = self.line()
        self.new_joint("prismatic", links=links, at=middle, **line)

    def add_bar_in_slot(self):
        end = self.pin_on(self.some_link())
        pin = self.new_point()
        base = self.some_link()
        bar = self.new_link(end, pin)
        # A slot drawn through the pin closes in the drawing; one beside it closes elsewhere.
        if self.random.random() < 0.8:
            while not any(direction := self.place()):
                pass
            line = {"direction": direction}
        else:
            line = self.line()
        self.new_joint("pin-in-slot", links=[bar, base], at=pin, **line)

    def add_cylinder(self):
        one, other = self.two_pins()
        tube, rod = self.new_link(one), self.new_link(other)
        for link in (tube, rod):
            if self.random.random() < 0.3:
                self.links[link].append(self.new_point())
        self.new_joint("prismatic", between=[f"{tube}.{one}", f"{rod}.{other}"])

    def add_driven_cylinder(self):
        """A lever on the ground, held by a cylinder whose length is given."""
        pin, end, foot = self.pin_on("ground"), self.new_point(), self.pin_on("ground")
        if pin == foot or self.points[foot] == self.points[end]:
            return
        self.new_link(pin, end)
        tube, rod = self.new_link(foot), self.new_link(end)
        self.drive(self.new_joint("prismatic", between=[f"{tube}.{foot}", f"{rod}.{end}"]))

    # ---- parameters and outputs ----

    def add_lengths(self):
        taken = set()
        for link in list(self.links):
            points = self.links[link]
            for place, point in enumerate(points):
                for first in points[:min(place, 2)]:
                    pair = frozenset((first, point))
                    if self.random.random() > 0.25 or pair in taken or self.is_elsewhere(pair, link):
                        continue
                    taken.add(pair)
                    x, y = (b - a for a, b in zip(self.points[first], self.points[point]))
                    entry = {"drawn": [first, point]}
                    if self.random.random() < 0.5:
                        factor = 1 + 1e-3 * self.random.random()
                        entry["value"] = (x * x + y * y) ** 0.5 * factor
                    self.parameters[f"l{len(self.parameters)}"] = entry

    def is_elsewhere(self, pair, link):
        """Whether a distance is out of reach in another link that lists both points, or flat."""
        if any(pair <= set(points) and not pair & set(points[:2])
               for name, points in self.links.items() if name != link):
            return True
        return any(self.is_flat(points) for points in self.links.values() if pair <= set(points))

    def is_flat(self, points):
        (ax, ay), (bx, by) = (self.points[point] for point in (points + points)[:2])
        return any(abs((bx - ax) * (y - ay) - (by - ay) * (x - ax)) < 1
                   for x, y in (self.points[point] for point in points[2:]))

    def scene(self):
        for _ in range(self.random.randint(1, 2)):
            self.random.choice([self.add_crank, self.add_crank, self.add_driven_cylinder])()
        if len(self.links) == 1:
            self.add_crank()
        groups = [self.add_bars, self.add_bars, self.add_slider, self.add_bar_in_slot,
                  self.add_cylinder]
        for _ in range(self.random.randint(1, 3)):
            self.random.choice(groups)()
        self.add_lengths()
        for name in self.random.sample(list(self.points), 2):  # coordinates that are formulas
            if self.random.random() < 0.3:
                parameter = f"x{len(self.parameters)}"
                self.parameters[parameter] = {"value": self.points[name][0], "tolerance": 0.01}
                self.points[name] = [parameter, self.points[name][1]]
        listed = [point for point in self.points if any(point in one for one in self.links.values())]
        scene = {"points": self.points, "links": self.links, "joints": self.joints,
                 "drivers": self.drivers, "parameters": self.parameters,
                 "outputs": self.random.sample(listed, min(2, len(listed)))}
        if not self.links["ground"]:
            del self.links["ground"]
        return {key: value for key, value in scene.items() if value}


def shuffled(scene, seed):
    """The same scene with its points, links, joints and parameters listed in another order."""
    order = random.Random(seed)
    result = {}
    for key, value in scene.items():
        if isinstance(value, dict):
            names = list(value)
            order.shuffle(names)
            value = {name: value[name] for name in names}
        result[key] = value
    return result
