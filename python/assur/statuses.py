"""Turns the numbers in arrays of statuses and outcomes into names."""

import enum


class _Word(enum.IntEnum):
    @property
    def word(self):
        """What the command calls it: ``no-assembly``."""
        return self.name.lower().replace("_", "-")

    def __str__(self):
        return self.word


class Status(_Word):
    """What became of a set of values."""

    OK = 0
    """There are configurations; there may be families beside them."""
    NO_ASSEMBLY = 1
    """The links cannot reach, or every configuration is beyond the limits of a joint."""
    DEGENERATE = 2
    """There are families only: a group moves freely, or is inconsistent."""


class Outcome(_Word):
    """What became of a sample."""

    REGULAR = 0
    """There is a configuration, whose derivatives keep six digits."""
    NEAR_SINGULAR = 1
    """There is one, whose loop Jacobian is nearly singular."""
    AMBIGUOUS = 2
    """The next configuration is less than three times as far from the nominal one."""
    BEYOND_LIMITS = 3
    """There are configurations, and none within the limits of joints."""
    NO_ASSEMBLY = 4
    """The links cannot reach."""
    DEGENERATE = 5
    """There are families only."""
    REFUSED = 6
    """A formula has no value there, or the solver refuses it."""
