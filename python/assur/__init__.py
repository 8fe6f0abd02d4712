"""Planar linkages in closed form: every assembly configuration of a scene, as NumPy arrays.

Angles are radians, lengths are in the scene's unit, rates are per unit of time. Arrays are
read-only views, each of which keeps its memory alive. A number that is not known to two digits is
NaN. Every error is an assur.Error, whose text is one line with the place, the fault and the remedy.

    import assur

    scene = assur.read_scene("four_bar.json")
    plan = assur.Plan(scene)
    solution = plan.solve(phi=1.0)
    solution[0].outputs["P"].position     # of the first configuration, shape (2,)
    solution.outputs["P"].sensitivity     # of all, shape (configurations, 2, parameters)
"""

from assur.errors import (Error, NotWanted, OverConstrained, SceneError, ShapeError, UnknownName)
from assur.statuses import Outcome, Status
from assur._assur import (Batch, Branch, Configuration, Events, Family, Group, ImportedScene,
                          JointState, Joints, LinkState, Links, Nearest, NominalPoint, OutputState,
                          Outputs, Plan, Samples, Scene, Solution, States, Sweep, __version__,
                          import_scene, parse_scene, read_scene, sample, scene_schema)

__all__ = ["Batch", "Branch", "Configuration", "Error", "Events", "Family", "Group",
           "ImportedScene", "JointState", "Joints", "LinkState", "Links", "Nearest", "NominalPoint",
           "NotWanted", "Outcome", "OutputState", "Outputs", "OverConstrained", "Plan", "Samples",
           "Scene", "SceneError", "ShapeError", "Solution", "States", "Status", "Sweep",
           "UnknownName", "import_scene", "parse_scene", "read_scene", "sample", "scene_schema"]
