function [th3, th4] = fourbar(a, b, c, d, th2)
  % Freudenstein, open branch
  K1 = d/a; K2 = d/c; K3 = (a^2 - b^2 + c^2 + d^2)/(2*a*c);
  A = cos(th2) - K1 - K2*cos(th2) + K3;
  B = -2*sin(th2);
  C = K1 - (K2+1)*cos(th2) + K3;
  th4 = 2*atan2(-B - sqrt(B^2 - 4*A*C), 2*A);
  K4 = d/b; K5 = (c^2 - d^2 - a^2 - b^2)/(2*a*b);
  D = cos(th2) - K1 + K4*cos(th2) + K5;
  E = -2*sin(th2);
  F = K1 + (K4-1)*cos(th2) + K5;
  th3 = 2*atan2(-E - sqrt(E^2 - 4*D*F), 2*D);
end
