function [p, J] = arm(a, b, q1, q2)
% arm of two links
  p = [a*cos(q1) + b*cos(q1 + q2);
       a*sin(q1) + b*sin(q1 + q2)];
  J = [-a*sin(q1) - b*sin(q1 + q2), -b*sin(q1 + q2)
       a*cos(q1) + b*cos(q1 + q2),  b*cos(q1 + q2)];
end
