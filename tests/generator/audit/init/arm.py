from math import sin, cos

def tip(a, b, q1, q2):
    """The tip of an arm."""
    x = a*cos(q1) + b*cos(q1 + q2)
    y = a*sin(q1) + b*sin(q1 + q2)
    return [x, y]

def jacobian(a, b, q1, q2):
    s12 = sin(q1 + q2)
    c12 = cos(q1 + q2)
    return [[-a*sin(q1) - b*s12, -b*s12],
            [a*cos(q1) + b*c12, b*c12]]

def velocity(a, b, q1, q2, w1, w2):
    J = jacobian(a, b, q1, q2)
    return [J[0][0]*w1 + J[0][1]*w2, J[1][0]*w1 + J[1][1]*w2]
