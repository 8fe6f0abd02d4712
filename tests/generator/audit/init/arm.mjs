const { sin, cos } = Math
export function tip(a, b, q) {
  const [q1, q2] = q
  return [a*cos(q1) + b*cos(q1 + q2), a*sin(q1) + b*sin(q1 + q2)]
}
export const jac = (a, b, q) => [
  [-a*sin(q[0]) - b*sin(q[0] + q[1]), -b*sin(q[0] + q[1])],
  [a*cos(q[0]) + b*cos(q[0] + q[1]), b*cos(q[0] + q[1])]
];
