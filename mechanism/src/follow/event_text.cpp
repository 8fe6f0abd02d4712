#include "event_text.hpp"

namespace assur::mechanism::follow {

namespace {

std::string listed(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) {
    text += " " + std::to_string(number);
  }
  return text;
}

}  // namespace

std::string event_text(const BranchEvent& event) {
  const std::string on = event.through > 0 ? " on " + std::to_string(event.through) : "";
  switch (event.kind) {
    case EventKind::fold:
      return "fold" + listed(event.ended) + on;
    case EventKind::birth:
      return "birth" + listed(event.begun) + on;
    case EventKind::crossing:
      return "crossing" + listed(event.ended);
    case EventKind::escape:
      return "escape" + listed(event.ended);
    case EventKind::arrival:
      return "arrival" + listed(event.begun);
    case EventKind::degenerate:
      return "degenerate" + listed(event.ended) + " /" + listed(event.begun);
    case EventKind::unresolved:
      return "unresolved" + listed(event.ended) + " /" + listed(event.begun);
  }
  return "";
}

}  // namespace assur::mechanism::follow
