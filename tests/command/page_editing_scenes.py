"""Scenes as they are drawn, for tests of pages on which drawings are edited."""

DRAWN = {
    "name": "A six-bar as it is drawn", "unit": "mm",
    "points": {"A": [0, 0], "B": [22.5, 26.8], "C": [98.5, 75], "D": ["AD", 0], "E": [43.7, 105.4],
               "F": [124.4, 132.2], "G": ["AD + 58.6", 71.2], "P": [151.3, 162.3]},
    "parameters": {"AD": 100, "AB": {"drawn": ["A", "B"], "tolerance": 0.02},
                   "EF": {"drawn": ["E", "F"], "value": 85, "tolerance": 0.05},
                   "phi": {"drawn": "A"}},
    "links": {"ground": ["A", "D"], "crank": ["A", "B"], "coupler": ["B", "C", "E"],
              "rocker": ["D", "C", "G"], "upper": ["E", "F", "P"], "outer": ["G", "F"]},
    "drivers": {"A": {"position": "phi", "velocity": 5}}, "outputs": ["P", "F"],
    "sweep": {"parameter": "phi", "from": 0, "to": "2*pi", "count": 361}}

SHORT = {"points": {"A": [0, 0], "B": [20, 34.6], "C": [3.1, -63.9], "D": [80, 0],
                    "P": [-13.8, -162.5]},
         "links": {"ground": ["A", "D"], "crank": ["A", "B"], "coupler": ["B", "C", "P"],
                   "rocker": ["D", "C"]},
         "drivers": {"A": {"velocity": 10}}, "outputs": ["P"]}
