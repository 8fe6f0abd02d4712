"""Exceptions of the package; their text is the line that the command prints."""


class Error(Exception):
    """The base of all exceptions of assur: one line with the place, the fault, and the remedy."""


class SceneError(Error, ValueError):
    """A scene, or a value of a parameter, cannot be read, solved, swept, sampled or drawn."""


class OverConstrained(SceneError):
    """A scene has more constraints than its links have freedoms.

    ``surplus`` is the number of excess constraints, and ``joints`` has the names of the joints
    among which these are.
    """

    surplus = 0
    joints = ()


class UnknownName(Error, LookupError):
    """The scene has no parameter, link, joint or output with this name."""


class ShapeError(Error, ValueError):
    """A value is not a number, or an array does not have the necessary shape or length."""


class NotWanted(Error, AttributeError):
    """The scene does not want this result, so it was not computed."""
