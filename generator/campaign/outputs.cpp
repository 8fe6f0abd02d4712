#include "campaign/outputs.hpp"

namespace assur::generator::campaign {

PendingOutputs::PendingOutputs(const Outputs& outputs, const Description& description)
    : drawing_(outputs.drawing) {
  if (!outputs.table.empty()) {
    table_.emplace(outputs.table);
    writer_ = table_writer(*table_, description);
  }
  if (!outputs.picture.empty()) {
    picture_.emplace(outputs.picture);
  }
}

void PendingOutputs::add(const std::vector<double>& rows, const std::string& text) {
  if (writer_) {
    writer_->add(rows, text);
  }
}

void PendingOutputs::finish() {
  std::vector<PartialFile*> files;
  if (writer_) {
    writer_->finish();
    files.push_back(&*table_);
  }
  if (picture_) {
    picture_->write(drawing_());
    picture_->flush();
    files.push_back(&*picture_);
  }
  PartialFile::take_names(files);
}

}  // namespace assur::generator::campaign
