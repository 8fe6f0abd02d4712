// Turns the number of steps done into a bar on a terminal's standard error.
#pragma once

namespace assur::generator::command {

/// One line that is drawn anew, and erased at the end. Where standard error is not a terminal,
/// nothing is written.
class ProgressBar {
 public:
  explicit ProgressBar(int count);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  void show(int done);

 private:
  int count_;
  int percent_ = -1;
  bool terminal_;
};

}  // namespace assur::generator::command
