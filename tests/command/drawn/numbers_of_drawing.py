"""Converts a drawn scene to the equivalent scene with link frames and numbers.

The oracle for drawn scenes. It knows nothing of formulas: points are complex numbers, evaluated at
one set of values of the parameters. Derivatives come from translating again at other values.
"""

import cmath
import math

FUNCTIONS = {name: getattr(math, name)
             for name in ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "atan2")}
CONSTANTS = {"pi": math.pi, "deg": math.pi / 180, "abs": abs, "min": min, "max": max}


def rank(link):
    """The order of links at a pin: the ground, then by name."""
    return link != "ground", link


def within_half_turn(angle):
    turned = math.remainder(angle, 2 * math.pi)
    return math.pi if turned == -math.pi else turned


class Drawing:
    """A drawn scene at one set of values; `settings` give parameters other ones."""

    def __init__(self, scene, settings=None, sides=None):
        self.scene = scene
        self.settings = settings or {}
        self.sides = sides if sides is not None else {}  # of points, once they are decided
        self.lists = {name: value for name, value in scene["links"].items()
                      if isinstance(value, list)}
        self.lists.setdefault("ground", []) if "ground" not in scene["links"] else None
        self.known = {}
        self.lengths = {}
        for name, entry in scene.get("parameters", {}).items():
            drawn = entry.get("drawn") if isinstance(entry, dict) else None
            if isinstance(drawn, list):
                for pair in drawn if isinstance(drawn[0], list) else [drawn]:
                    self.lengths[frozenset(pair)] = name

    # ---- numbers ----

    def number(self, text):
        if not isinstance(text, str):
            return float(text)

        class Names(dict):
            def __missing__(names, name):
                return self.parameter(name)

        return float(eval(text.replace("^", "**"), {"__builtins__": {}},
                          Names(FUNCTIONS, **CONSTANTS)))

    def parameter(self, name):
        if name not in self.known:
            entry = self.scene["parameters"][name]
            drawn = entry.get("drawn") if isinstance(entry, dict) else None
            if name in self.settings:
                self.known[name] = self.number(self.settings[name])
            elif drawn is None or "value" in entry:
                self.known[name] = self.number(entry["value"] if isinstance(entry, dict) else entry)
            elif isinstance(drawn, list):
                self.known[name] = abs(self.point(drawn[1]) - self.point(drawn[0]))
            else:
                self.known[name] = self.joints()[drawn][1]
        return self.known[name]

    def point(self, name):
        x, y = self.scene["points"][name]
        return complex(self.number(x), self.number(y))

    # ---- links ----

    def frame(self, link):
        """Origin and x-axis in the drawing."""
        points = self.lists[link]
        if link == "ground":
            return 0, 1
        origin = self.point(points[0])
        if len(points) == 1:
            return origin, 1
        along = self.point(points[1]) - origin
        return origin, along / abs(along)

    def angle(self, link):
        return cmath.phase(self.frame(link)[1])

    def place(self, link, name):
        """Where a point is in the frame of a link."""
        points = self.lists[link]
        origin, axis = self.frame(link)
        own = (self.point(name) - origin) / axis
        if name not in points or len(points) < 2 or name == points[0]:
            return own

        def given(*pair):
            parameter = self.lengths.get(frozenset(pair))
            return parameter and self.parameter(parameter)

        first, second = (self.point(point) for point in points[:2])
        base = given(*points[:2]) or abs(second - first)
        turn = (second - first) / abs(second - first)
        drawn = (self.point(name) - first) / turn
        by_first = given(points[0], name)
        by_second = given(points[1], name)
        if name == points[1]:
            local = base
        elif by_first and by_second:
            # Two circles about the first and the second point.
            side = self.sides.setdefault((link, name), math.copysign(1, drawn.imag))
            cosine = (by_first**2 + base**2 - by_second**2) / (2 * base * by_first)
            local = cmath.rect(by_first, side * math.acos(cosine))
        elif by_first:
            local = cmath.rect(by_first, cmath.phase(drawn))
        elif by_second:
            ray = drawn - abs(second - first)
            local = base + cmath.rect(by_second, cmath.phase(ray))
        else:
            return own
        # The ground is not measured from its first point.
        return first + local * turn if link == "ground" else local

    def line(self, link, begin, end, first=None, second=None):
        """A line of the drawing in the frame of a link; its ends may be points that it lists."""
        own = [point for point in (first, second) if point in self.lists[link]]
        unit = (end - begin) / abs(end - begin) / self.frame(link)[1]
        through = (begin - self.frame(link)[0]) / self.frame(link)[1]
        if len(own) == 2:
            through, unit = self.place(link, first), self.place(link, second) - self.place(link, first)
        elif own == [first]:
            through = self.place(link, first)
        elif own == [second]:
            through = self.place(link, second) - abs(end - begin) * unit
        return {"through": [through.real, through.imag], "along": [unit.real, unit.imag]}

    # ---- joints ----

    def joints(self):
        """Each joint with the places that it joins, and its coordinate as drawn.

        A place is (link, point) or (link, line)."""
        found = {name: self.explicit(name, joint)
                 for name, joint in self.scene.get("joints", {}).items()}
        for point in self.scene.get("points", {}):
            sets = [{link} for link, points in self.lists.items() if point in points]
            given = self.scene.get("joints", {}).items()
            for name, joint in given:
                if joint["type"] == "pin-in-slot" and joint.get("at", name) == point:
                    sets = [part for part in sets if part != {joint["links"][1]}]
            for name, joint in given:
                if joint["type"] == "revolute":
                    joined = {link for link, own in self.ends(name, joint) if own == point}
                    met = set().union(*(part for part in sets if part & joined))
                    sets = [part for part in sets if not part & joined] + ([met] if met else [])
            if len(sets) > 1:
                links = sorted((min(part, key=rank) for part in sets), key=rank)
                found[point] = ("revolute", [(link, point) for link in links]), self.turn(links), {}
        return found

    @staticmethod
    def ends(name, joint):
        if "between" in joint:
            return [tuple(feature.split(".")) for feature in joint["between"]]
        return [(link, joint.get("at", name)) for link in joint["links"]]

    def turn(self, links):
        if len(links) != 2 or any(link not in self.lists for link in links):
            return None
        return within_half_turn(self.angle(links[1]) - self.angle(links[0]))

    def explicit(self, name, joint):
        kind = joint["type"]
        rest = {"limits": [self.number(limit) for limit in joint["limits"]]} if "limits" in joint else {}
        if kind == "revolute":
            ends = self.ends(name, joint)
            return (kind, ends), self.turn([link for link, _ in ends]), rest
        if "between" in joint:
            ends = self.ends(name, joint)
            if any(link not in self.lists for link, _ in ends):
                return (kind, ends), None, rest
            (one, first), (other, second) = ends
            begin, end = self.point(first), self.point(second)
            lines = [(link, self.line(link, begin, end, first, second)) for link in (one, other)]
            for (link, line), (_, point) in zip(lines, ends):
                own = self.place(link, point)
                line["through"] = [own.real, own.imag]
            return (kind, lines), abs(end - begin), rest
        at = joint.get("at", name)
        if "along" in joint:
            first, second = joint["along"]
            begin, end = self.point(first), self.point(second)
        else:
            first, second, begin = at, None, self.point(at)
            end = begin + complex(*(self.number(part) for part in joint["direction"]))
        if kind == "prismatic":
            return (kind, [(link, self.line(link, begin, end, first, second))
                           for link in joint["links"]]), 0, rest
        pinned, slotted = joint["links"]
        along = ((self.point(at) - begin) * ((end - begin) / abs(end - begin)).conjugate()).real
        return (kind, [(pinned, at),
                       (slotted, self.line(slotted, begin, end, first, second))]), along, rest

    # ---- the whole ----

    def translated(self):
        scene = self.scene
        joints = self.joints()
        links = {}
        for link, value in scene["links"].items():
            links[link] = {} if link in self.lists else {
                name: self.numbers(feature, value) for name, feature in value.items()}
        links.setdefault("ground", {})
        for link, points in self.lists.items():
            for point in points:
                self.add(links, link, point)
        result = {"parameters": {name: self.parameter(name)
                                 for name in scene.get("parameters", {})},
                  "links": links, "joints": {}, "drivers": {}, "outputs": {}}
        for name, ((kind, places), _, rest) in joints.items():
            between = []
            for link, place in places:
                if isinstance(place, dict):
                    links[link]["line of " + name] = place
                    place = "line of " + name
                elif link in self.lists:
                    self.add(links, link, place)
                between.append(f"{link}.{place}")
            result["joints"][name] = {"type": kind, "between": between, **rest}
        for name, driver in scene.get("drivers", {}).items():
            law = driver.get("position", joints[name][1])
            result["drivers"][name] = {
                **{key: self.number(driver[key]) for key in driver if key != "position"},
                "position": law}
        outputs = scene.get("outputs", {})
        for name, point in (outputs if isinstance(outputs, dict) else {p: p for p in outputs}).items():
            if "." in point:
                link, point = point.split(".")
            else:
                owners = sorted((link for link in self.lists if point in self.lists[link]), key=rank)
                link = next((one for one in owners if one != "ground"), "ground")
            if link in self.lists:
                self.add(links, link, point)
            result["outputs"][name] = f"{link}.{point}"
        result["reference"] = {link: self.angle(link) for link in self.lists if link != "ground"}
        for key in ("want", "report", "redundancy"):
            if key in scene:
                result[key] = scene[key]
        return result

    def add(self, links, link, point):
        own = self.place(link, point)
        links[link][point] = [own.real, own.imag]

    def numbers(self, feature, link):
        """A feature of a link with a frame of its own."""
        if isinstance(feature, list):
            return [self.number(part) for part in feature]
        if "from" not in feature:
            return {key: self.numbers(value, link) for key, value in feature.items()}
        begin, end = (self.numbers(link[feature[key]], link) for key in ("from", "to"))
        return {"through": begin, "along": [b - a for a, b in zip(begin, end)]}
