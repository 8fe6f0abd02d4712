"""Turns what cannot be used into exceptions; their text is the line that the command prints."""


class Error(Exception):
    """What every exception of assur is: one line with the place, what is wrong, and the mend."""


class SceneError(Error, ValueError):
    """A scene, or a value of a parameter, cannot be read, solved, swept, sampled or drawn."""


class OverConstrained(SceneError):
    """There are more constraints than the links have freedoms.

    ``surplus`` is how many are too many, ``joints`` the names of the joints among which they are.
    """

    surplus = 0
    joints = ()


class UnknownName(Error, LookupError):
    """The scene has no parameter, link, joint or output of that name."""


class ShapeError(Error, ValueError):
    """A value is no number, or an array has not the shape or the length that is needed."""


class NotWanted(Error, AttributeError):
    """The scene does not ask for this result, so that it was not computed."""
