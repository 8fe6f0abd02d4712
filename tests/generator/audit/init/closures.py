import numpy as np


def closures(q, p):
    phi, x = q
    return np.array([p[0]*np.cos(p[2]) + p[1]*np.cos(phi) - x,
                     p[0]*np.sin(p[2]) + p[1]*np.sin(phi)])


def jacobian(q, p):
    J = np.zeros((2, 2))
    J[0, 0] = -p[1]*np.sin(q[0])
    J[0, 1] = -1
    J[1, 0] = p[1]*np.cos(q[0])
    return J
