import sympy as sp
a, b, q1, q2 = sp.symbols('a b q1 q2', real=True)
P = sp.Matrix([a*sp.cos(q1) + b*sp.cos(q1 + q2), a*sp.sin(q1) + b*sp.sin(q1 + q2)])
J = sp.Matrix([[-a*sp.sin(q1) - b*sp.sin(q1+q2), -b*sp.sin(q1+q2)],
               [a*sp.cos(q1) + b*sp.cos(q1+q2), b*sp.cos(q1+q2)]])
