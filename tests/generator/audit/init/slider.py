from math import asin, cos, sin


def rod(r, l, th):
    return asin(-r*sin(th)/l)


def slider(r, l, th):
    phi = rod(r, l, th)
    x = r*cos(th) + l*cos(phi)
    return x, phi
