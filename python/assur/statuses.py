"""Enumerations for the numbers in arrays of statuses and outcomes."""

import enum


class _Word(enum.IntEnum):
    @property
    def word(self):
        """str: the word that the command prints, such as ``no-assembly``."""
        return self.name.lower().replace("_", "-")

    def __str__(self):
        return self.word


class Status(_Word):
    """The result of solving one set of values.

    OK: there are configurations; there may be families beside them.
    NO_ASSEMBLY: the links cannot reach, or every configuration is beyond the limits of a joint.
    DEGENERATE: there are families only, since a group moves freely or is inconsistent.
    REFUSED: the values cannot be solved; only in a batch that follows a branch.
    """

    OK = 0
    NO_ASSEMBLY = 1
    DEGENERATE = 2
    REFUSED = 3


class Outcome(_Word):
    """The result of solving one sample.

    REGULAR: there is a configuration, whose derivatives keep six digits.
    NEAR_SINGULAR: there is a configuration, and its loop Jacobian is nearly singular.
    AMBIGUOUS: the next configuration is less than three times as far from the nominal one.
    BEYOND_LIMITS: there are configurations, but none within the limits of joints.
    NO_ASSEMBLY: the links cannot reach.
    DEGENERATE: there are families only.
    REFUSED: a formula has no value there, or the solver refuses the values.
    """

    REGULAR = 0
    NEAR_SINGULAR = 1
    AMBIGUOUS = 2
    BEYOND_LIMITS = 3
    NO_ASSEMBLY = 4
    DEGENERATE = 5
    REFUSED = 6
