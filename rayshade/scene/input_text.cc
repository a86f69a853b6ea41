// Where the text of a scene comes from; see input_text.h.
#include "rayshade/scene/input_text.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

namespace rayshade {
namespace {

ssize_t ReadSome(int file, char* buffer, size_t size) {
  ssize_t count;
  do {
    count = read(file, buffer, size);
  } while (count < 0 && errno == EINTR);
  return count;
}

// Reads through a file that can be wound back, to see whether the preprocessor could matter.
bool MustPreprocess(int file) {
  const off_t start = lseek(file, 0, SEEK_CUR);
  struct stat about;
  if (start < 0 || fstat(file, &about) != 0 || !S_ISREG(about.st_mode)) return true;
  constexpr size_t kPiece = 1 << 18;
  std::vector<char> buffer(kPieceOverlap + kPiece);
  size_t kept = 0;  // bytes of the piece before, in front of this one
  bool matters = false;
  while (!matters) {
    const ssize_t count = ReadSome(file, buffer.data() + kept, kPiece);
    if (count < 0) matters = true;
    if (count <= 0) break;
    const size_t size = kept + static_cast<size_t>(count);
    matters = PreprocessorMatters({buffer.data(), size});
    kept = std::min(size, kPieceOverlap);
    std::memmove(buffer.data(), buffer.data() + size - kept, kept);
  }
  return lseek(file, start, SEEK_SET) != start || matters;
}

}  // namespace

InputText::~InputText() {
  if (file_ > STDIN_FILENO) close(file_);
}

bool InputText::Open(const Options& options, Diagnostics* diagnostics) {
  diagnostics_ = diagnostics;
  const bool standard_input = options.input.empty();
  name_ = !standard_input ? options.input : options.raw_input ? "stdin" : "<stdin>";
  file_ = standard_input ? STDIN_FILENO : open(options.input.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat about;
  if (file_ < 0 || fstat(file_, &about) != 0 || S_ISDIR(about.st_mode)) {
    diagnostics->Report(Severity::kFatal, {}, "Cannot open " + name_ + ".");
    return false;
  }
  from_ = file_;
  if (options.raw_input) return true;
  const bool skip = options.preprocessor_arguments.empty() && !MustPreprocess(file_);
  return skip || StartPreprocessor(options);
}

bool InputText::StartPreprocessor(const Options& options) {
  const int error = preprocessor_.Start(SplitWords(options.preprocessor_arguments), options.input);
  if (error == ENOENT) {
    diagnostics_->Report(Severity::kFatal, {},
                         "Cannot run the C preprocessor: no program cpp was found. Install it, or "
                         "use -u for a scene that needs none.");
  } else if (error) {
    diagnostics_->Report(Severity::kFatal, {},
                         std::string("Cannot run cpp: ") + std::strerror(error) + ".");
  }
  from_ = preprocessor_.output();
  return error == 0;
}

size_t InputText::Read(char* buffer, size_t size) {
  const ssize_t count = ReadSome(from_, buffer, size);
  if (count >= 0) return static_cast<size_t>(count);
  diagnostics_->Report(Severity::kFatal, {},
                       "Cannot read " + name_ + ": " + std::strerror(errno) + ".");
  return 0;
}

void InputText::Finish() {
  if (!preprocessor_.Finish()) {
    diagnostics_->Report(
        Severity::kWarn, {name_, 0},
        "The preprocessor complained about " + name_ + "; only what it passed on is rendered.");
  }
}

}  // namespace rayshade
