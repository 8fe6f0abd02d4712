const { sin, cos } = Math;

function closures(p, crank, rod, x) {
  return [p.r * cos(crank) + p.l * cos(rod) - x, p.r * sin(crank) + p.l * sin(rod)];
}

function jacobian(p, crank, rod, x) {
  const J = [[0, 0], [0, 0]];
  J[0][0] = -p.l * sin(rod);
  J[0][1] = -1;
  J[1][0] = p.l * cos(rod);
  return J;
}

module.exports = { closures, jacobian };
