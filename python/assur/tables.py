"""Results as tables of pandas, whose columns have the names of the command's CSV."""

from assur._assur import Batch, Branch, Events, Samples, Solution, Sweep
from assur.errors import NotWanted
from assur.statuses import Outcome

# The columns of a link, a joint and an output: the array, and the index if it has more than one
# number.
_LINK = {"x": ("pose", 0), "y": ("pose", 1), "theta": ("pose", 2),
         "vx": ("velocity", 0), "vy": ("velocity", 1), "omega": ("velocity", 2),
         "ax": ("acceleration", 0), "ay": ("acceleration", 1), "alpha": ("acceleration", 2)}
_JOINT = {name: (name,) for name in ("displacement", "velocity", "acceleration")}
_OUTPUT = {"x": ("position", 0), "y": ("position", 1),
           "vx": ("velocity", 0), "vy": ("velocity", 1),
           "ax": ("acceleration", 0), "ay": ("acceleration", 1),
           "a_tangential": ("tangential",), "a_normal": ("normal",),
           "worst_case_x": ("worst_case", 0), "worst_case_y": ("worst_case", 1),
           "rss_x": ("rss", 0), "rss_y": ("rss", 1),
           "variance_x": ("covariance", 0, 0), "variance_y": ("covariance", 1, 1),
           "covariance_xy": ("covariance", 0, 1),
           "mean_shift_x": ("mean_shift", 0), "mean_shift_y": ("mean_shift", 1)}


def _force_columns(forces, deviation=""):
    """The columns of efforts, joints and the ground, and of worst case and rss if present."""
    columns = {f"{name}.{deviation}effort": effort for name, effort in forces["efforts"].items()}
    for name, joint in (*forces["joints"].items(), ("ground", forces["ground"])):
        on = {f"{name}.{link}": force for link, force in joint.get("forces", {}).items()}
        for of, force in (on or {name: joint["force"]}).items():
            columns[f"{of}.{deviation}fx"], columns[f"{of}.{deviation}fy"] = force.T
        if "moment" in joint:
            columns[f"{name}.{deviation}moment"] = joint["moment"]
    return columns


def _wanted_force_columns(result):
    """The columns of forces of all rows; none if the scene does not request forces."""
    try:
        forces = result.forces
    except NotWanted:
        return {}
    columns = _force_columns(forces)
    for deviation in ("worst_case", "rss"):
        if deviation in forces:
            columns.update(_force_columns(forces[deviation], deviation + "_"))
    return columns


def _state_columns(states):
    """The columns of all rows; results that the scene does not request have none."""
    columns = {}
    for parts, fields in ((states.links, _LINK), (states.joints, _JOINT),
                          (states.outputs, _OUTPUT)):
        for name, part in parts.items():
            if name == "ground":
                continue
            for column, (array, *place) in fields.items():
                try:
                    columns[f"{name}.{column}"] = getattr(part, array)[(slice(None), *place)]
                except NotWanted:
                    pass
    columns.update(_wanted_force_columns(states))
    columns["regular"] = states.regular
    columns["residual"] = states.residual
    return columns


def _sample_columns(samples):
    columns = {"outcome": [Outcome(one).word for one in samples.outcome]}
    for place, name in enumerate(samples.deviations):
        columns[name] = samples.parameters[:, place]
    for name, position in samples.positions.items():
        columns[f"{name}.x"], columns[f"{name}.y"] = position.T
    columns.update(_wanted_force_columns(samples))
    return columns


def _columns(result, parameter):
    if isinstance(result, Samples):
        return _sample_columns(result)
    columns = {}
    if isinstance(result, Solution):
        columns["configuration"] = [one.number for one in result]
    elif isinstance(result, Batch):
        columns.update(item=result.item, configuration=result.configuration)
    elif isinstance(result, Branch):
        columns.update({"step": result.step, "configuration": result.configuration,
                        "branch": result.number, parameter: result.parameter})
    elif isinstance(result, Events):
        columns.update({"step": result.step, parameter: result.parameter, "event": result.event})
    columns.update(_state_columns(result))
    return columns


def frame_of(result):
    """Returns a DataFrame of a solution, a batch, a sweep, a branch, its events or samples."""
    kinds = (Batch, Branch, Events, Samples, Solution, Sweep)
    if not isinstance(result, kinds):
        raise TypeError(f"to_frame: expected one of {', '.join(kind.__name__ for kind in kinds)}, "
                        f"not {type(result).__name__}")
    try:
        import pandas
    except ImportError:
        raise ImportError("to_frame needs pandas, which is not installed; apt-get install "
                          "python3-pandas, or pip install pandas") from None
    if isinstance(result, Sweep):
        rows = [pandas.DataFrame(_columns(branch, result.parameter))
                for branch in (*result.branches.values(), result.unassigned) if len(branch) > 0]
        if not rows:
            rows = [pandas.DataFrame(_columns(result.unassigned, result.parameter))]
        return pandas.concat(rows, ignore_index=True)
    return pandas.DataFrame(_columns(result, "parameter"))
