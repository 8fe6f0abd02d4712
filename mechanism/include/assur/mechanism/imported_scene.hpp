// Turns what another program has written of a mechanism into a drawn scene.
#pragma once

#include <string>
#include <vector>

namespace assur::mechanism {

/// A drawn scene made of another program's file.
struct ImportedScene {
  std::string text;                  ///< what a scene file holds
  std::vector<std::string> remarks;  ///< a line for each thing that the scene does not say
  /// Whether all that holds or drives the mechanism is in the scene. Otherwise remarks tell what is
  /// missing.
  bool complete = true;
};

/// Reads a file of Linkage (`.linkage2`), a link that PMKS+ shares, with its address or without, or
/// an expression of Pyslvs. The text itself tells which of them it is; `file` is its name in
/// messages. Coordinates are those of the file, y upward; times are seconds, angles radians. An
/// expression of Pyslvs names no driven joint: `driver` is the point, as `P0`, at which it is
/// driven; where it is empty, the first pin of one link on the ground is. The text need not be a
/// scene that can be solved: the file may hold a mechanism that lacks a link. Throws InputError
/// with one line, file, place, what is wrong and the remedy, where the text cannot be read.
[[nodiscard]] ImportedScene import_scene(const std::string& text, const std::string& file,
                                         const std::string& driver = {});

/// Whether a text is a link that PMKS+ shares, with its address or without, or an expression of
/// Pyslvs, rather than the name of a file that holds one.
[[nodiscard]] bool is_shared_mechanism(const std::string& text);

}  // namespace assur::mechanism
