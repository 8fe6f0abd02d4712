// A parallelogram with a third crank of given position and length.
#pragma once

#include "mechanism/bars.hpp"

namespace assur::test {

/// A parallelogram with a third crank, which is redundant.
inline Bars five_bars(double third_pivot, double third_length) {
  Bars bars;
  bars.json()["links"]["crank"]["B"] = {1.5, 0};
  bars.json()["drivers"]["A"]["velocity"] = 2;
  bars.point("ground", "D", 4, 0).point("coupler", "B", 0, 0).point("coupler", "C", 4, 0);
  bars.point("rocker", "D", 0, 0).point("rocker", "C", 1.5, 0);
  bars.point("ground", "F", third_pivot, 0).point("coupler", "G", 2, 0);
  bars.point("third", "F", 0, 0).point("third", "G", third_length, 0);
  bars.join("B", {"crank.B", "coupler.B"}).join("C", {"coupler.C", "rocker.C"});
  bars.join("D", {"ground.D", "rocker.D"}).join("F", {"ground.F", "third.F"});
  bars.join("G", {"coupler.G", "third.G"});
  bars.json()["outputs"]["G"] = "third.G";
  return bars;
}

}  // namespace assur::test
