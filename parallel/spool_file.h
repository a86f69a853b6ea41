// A temporary file of records (size, bytes) that is appended to and read in passes. It has no name
// and vanishes with the process. Errors (a full disk) are std::runtime_error naming the directory.
#pragma once

#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

namespace rayshade::parallel {

class SpoolFile {
 public:
  SpoolFile();  // in $TMPDIR, or /tmp
  ~SpoolFile();
  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;

  uint64_t size() const { return size_; }  // bytes appended: where the next record will stand
  void Append(std::span<const uint8_t> record);
  void Clear();

  // Reading starts at a record's place; Next gives false at the end. Appending and reading may
  // alternate.
  void Seek(uint64_t place);
  bool Next(std::vector<uint8_t>* record);

 private:
  [[noreturn]] void Fail(const char* what) const;

  std::FILE* file_ = nullptr;
  uint64_t size_ = 0;
  uint64_t at_ = 0;
  bool reading_ = false;
};

}  // namespace rayshade::parallel
