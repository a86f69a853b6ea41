// The transcript that --transcript asks for.
#pragma once

#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include "parallel/sim/transcript.h"

namespace rayshade::parallel {

class TranscriptFile {
 public:
  // name: "-" is standard output, "" no transcript. Throws std::runtime_error where the file cannot
  // be written.
  explicit TranscriptFile(const std::string& name) {
    if (name.empty()) return;
    if (name != "-") {
      file_.open(name);
      if (!file_) throw std::runtime_error("--transcript " + name + ": cannot be written");
    }
    transcript_ = std::make_unique<Transcript>(name == "-" ? &std::cout : &file_);
  }
  // Null where none was asked for.
  Transcript* get() const { return transcript_.get(); }

 private:
  std::ofstream file_;
  std::unique_ptr<Transcript> transcript_;
};

}  // namespace rayshade::parallel
