// Import of other programs' mechanisms as drawn scenes.
#pragma once

#include <string>
#include <vector>

namespace assur::mechanism {

/// A drawn scene from another program's file.
struct ImportedScene {
  std::string text;                  ///< the content of a scene file
  std::vector<std::string> remarks;  ///< a line for each thing that the scene does not express
  /// Whether the scene has all joints and drivers of the mechanism. Otherwise remarks name the
  /// missing ones.
  bool complete = true;
};

/// Reads a file of Linkage (`.linkage2`), a link shared by PMKS+, with or without its address, or
/// an expression of Pyslvs. The format is recognised from the text; `file` is its name in messages.
/// Coordinates are those of the file, y upward; times are seconds, angles radians. An expression of
/// Pyslvs names no driven joint: `driver` is the driven point, such as `P0`; if it is empty, the
/// first pin of one link on the ground is driven. The scene may be unsolvable, since the file may
/// hold a mechanism that lacks a link. Throws InputError with one line, the file, the place, the
/// fault and the remedy, if the text cannot be read.
[[nodiscard]] ImportedScene import_scene(const std::string& text, const std::string& file,
                                         const std::string& driver = {});

/// Whether a text is a link shared by PMKS+, with or without its address, or an expression of
/// Pyslvs, and not the name of a file.
[[nodiscard]] bool is_shared_mechanism(const std::string& text);

}  // namespace assur::mechanism
