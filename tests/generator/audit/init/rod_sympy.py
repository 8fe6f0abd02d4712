from sympy import Matrix, cos, sin, symbols

r, l, th, ph, x = symbols('r l th ph x', real=True)
f = Matrix([r*cos(th) + l*cos(ph) - x, r*sin(th) + l*sin(ph)])
J = Matrix([[-l*sin(ph), -1], [l*cos(ph), 0]])
