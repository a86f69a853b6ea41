// Writing beside and renaming; see output_file.h.
#include "rayshade/image/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace rayshade {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const char* attempt, const std::string& name, const char* what, int error) {
  throw std::runtime_error(std::string(attempt) + name + what + ": " + std::strerror(error) + ".");
}

// True for what has a name but cannot be replaced: devices, pipes.
bool IsSpecial(const std::string& name) {
  std::error_code ignored;
  const fs::file_status status = fs::status(name, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

std::string BehindLinks(const std::string& name) {
  std::error_code error;
  const fs::path target = fs::is_symlink(name, error) ? fs::canonical(name, error) : fs::path(name);
  return error || target.empty() ? name : target.string();
}

}  // namespace

OutputFile::OutputFile(const std::string& name) : name_(name) {
  if (name == "-") {
    stream_ = stdout;
    return;
  }
  target_ = BehindLinks(name);
  if (!IsSpecial(target_)) temporary_ = target_ + "." + std::to_string(getpid()) + ".tmp";
  stream_ = std::fopen((temporary_.empty() ? target_ : temporary_).c_str(), "wb");
  if (!stream_) Fail("Cannot open ", name_, " for writing", errno);
}

OutputFile::~OutputFile() {
  if (!stream_) return;
  if (stream_ != stdout) std::fclose(stream_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::Commit() {
  std::FILE* stream = stream_;
  errno = 0;
  bool failed = std::ferror(stream) || std::fflush(stream) != 0;
  if (stream != stdout) {
    stream_ = nullptr;
    failed = (std::fclose(stream) != 0) || failed;
  }
  const int error = errno ? errno : EIO;
  if (failed) {
    if (!temporary_.empty()) unlink(temporary_.c_str());
    Fail("Cannot write ", name_, "", error);
  }
  if (!temporary_.empty() && std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    const int rename_error = errno;
    unlink(temporary_.c_str());
    Fail("Cannot write ", name_, "", rename_error);
  }
}

void OutputFile::Check(const std::string& name) {
  if (name == "-") return;
  const std::string target = BehindLinks(name);
  if (fs::is_directory(target)) Fail("Cannot open ", name, " for writing", EISDIR);
  if (access(target.c_str(), F_OK) == 0) {
    if (access(target.c_str(), W_OK) != 0) Fail("Cannot open ", name, " for writing", errno);
    if (IsSpecial(target)) return;
  }
  const fs::path directory = fs::path(target).parent_path();
  const std::string place = directory.empty() ? "." : directory.string();
  if (access(place.c_str(), W_OK | X_OK) != 0) Fail("Cannot open ", name, " for writing", errno);
  if (!fs::is_directory(place)) Fail("Cannot open ", name, " for writing", ENOTDIR);
}

}  // namespace rayshade
