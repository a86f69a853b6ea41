// Unlinked temporary files; see spool_file.h.
#include "parallel/spool_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

namespace rayshade::parallel {

namespace {

std::string Directory() {
  const char* from_environment = std::getenv("TMPDIR");
  return from_environment != nullptr && *from_environment != '\0' ? from_environment : "/tmp";
}

}  // namespace

void SpoolFile::Fail(const char* what) const {
  throw std::runtime_error(std::string(what) + " a temporary file in " + Directory() + ": " +
                           std::strerror(errno) + " (set TMPDIR to a directory with more room)");
}

SpoolFile::SpoolFile() {
  std::string name = Directory() + "/prayshade-spool-XXXXXX";
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0) Fail("cannot create");
  unlink(name.c_str());
  file_ = fdopen(descriptor, "w+b");
  if (file_ == nullptr) Fail("cannot open");
}

SpoolFile::~SpoolFile() { std::fclose(file_); }

void SpoolFile::Append(std::span<const uint8_t> record) {
  if (reading_) {
    if (fseeko(file_, static_cast<off_t>(size_), SEEK_SET) != 0) Fail("cannot seek in");
    reading_ = false;
  }
  const uint32_t count = static_cast<uint32_t>(record.size());
  if (fwrite_unlocked(&count, sizeof count, 1, file_) != 1 ||
      fwrite_unlocked(record.data(), 1, record.size(), file_) != record.size()) {
    Fail("cannot write");
  }
  size_ += sizeof count + record.size();
}

void SpoolFile::Clear() {
  std::rewind(file_);
  if (ftruncate(fileno(file_), 0) != 0) Fail("cannot empty");
  size_ = 0;
  reading_ = false;
}

void SpoolFile::Seek(uint64_t place) {
  if (std::fflush(file_) != 0) Fail("cannot write");
  if (fseeko(file_, static_cast<off_t>(place), SEEK_SET) != 0) Fail("cannot seek in");
  at_ = place;
  reading_ = true;
}

bool SpoolFile::Next(std::vector<uint8_t>* record) {
  if (at_ == size_) return false;
  uint32_t count;
  if (fread_unlocked(&count, sizeof count, 1, file_) != 1) Fail("cannot read");
  record->resize(count);
  if (fread_unlocked(record->data(), 1, count, file_) != count) Fail("cannot read");
  at_ += sizeof count + count;
  return true;
}

}  // namespace rayshade::parallel
