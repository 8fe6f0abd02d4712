import numpy as np


class Lever:
    def __init__(self, a):
        self.a = a


def pin(p, th):
    return np.array([p.a*np.cos(th), p.a*np.sin(th) + p.h])


def pin_rate(p, th, w):
    return w*np.array([-p.a*np.sin(th), p.a*np.cos(th)])
