// A file that is whole or as before: written beside its name and renamed when complete. Names of
// devices and pipes are written to directly; "-" is standard output.
#pragma once

#include <cstdio>
#include <string>

namespace rayshade {

class OutputFile {
 public:
  // Throws std::runtime_error naming file and reason, as do all functions here.
  explicit OutputFile(const std::string& name);
  // Without Commit nothing is left behind.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::FILE* stream() { return stream_; }
  // Everything is on the disk and the name stands for it.
  void Commit();

  // Throws where the file could not be written: missing directory, no permission, a directory of
  // that name.
  static void Check(const std::string& name);

 private:
  std::string name_;       // as given
  std::string target_;     // behind symbolic links
  std::string temporary_;  // "": written to directly
  std::FILE* stream_ = nullptr;
};

}  // namespace rayshade
