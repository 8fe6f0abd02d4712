// Turns a scene file into a picture of it.
#pragma once

#include <string>
#include <vector>

namespace assur::generator::command {

struct DrawOptions {
  std::string scene;
  std::vector<std::string> settings;
  std::string output;     ///< the file; its extension says which form it has
  int configuration = 0;  ///< 0 for all
  bool nearest = false;   ///< the configuration nearest to the scene's reference
  bool moving = false;    ///< a branch of the sweep in motion
};

/// Draws the scene and writes the file. Throws InputError for what cannot be used or drawn, for an
/// extension that is not known, and where the file cannot be written: it is then as it was before.
void draw_scene(const DrawOptions& options);

}  // namespace assur::generator::command
