# The tip of an arm of two links and its Jacobian, which has a slip.
from math import cos, sin

def tip(a, b, q1, q2):
    return [a*cos(q1) + b*cos(q1 + q2), a*sin(q1) + b*sin(q1 + q2)]

def jacobian(a, b, q1, q2):
    return [[-a*sin(q1) - b*sin(q1 + q2), -b*sin(q1 + q2)],
            [a*cos(q1) + b*cos(q1 + q2), b*sin(q1 + q2)]]
