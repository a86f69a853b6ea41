// The text of a scene: a file or standard input, through the preprocessor or not, as a stream of
// bytes.
#pragma once

#include <string>

#include "rayshade/common/diagnostics.h"
#include "rayshade/scene/options.h"
#include "rayshade/scene/preprocess.h"

namespace rayshade {

class InputText {
 public:
  ~InputText();

  // False where there is nothing to read (reported).
  bool Open(const Options& options, Diagnostics* diagnostics);
  // At most `size` bytes; 0 at the end. An error of the device ends the text and is reported.
  size_t Read(char* buffer, size_t size);
  // After the end: warns where the preprocessor failed, what came before being used.
  void Finish();
  // What messages call it until the text says otherwise.
  const std::string& name() const { return name_; }

 private:
  bool StartPreprocessor(const Options& options);

  Diagnostics* diagnostics_ = nullptr;
  std::string name_;
  int file_ = -1;  // descriptor; standard input is not ours to close
  int from_ = -1;  // what is read
  Preprocessor preprocessor_;
};

}  // namespace rayshade
