// cpp as a child process; see preprocess.h.
#include "rayshade/scene/preprocess.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <sstream>

extern char** environ;

namespace rayshade {
namespace {

// Does `text` hold `first` followed by one of `next`?
bool HasPair(std::string_view text, char first, std::string_view next) {
  for (size_t at = text.find(first); at != std::string_view::npos; at = text.find(first, at + 1)) {
    if (at + 1 < text.size() && next.find(text[at + 1]) != std::string_view::npos) return true;
  }
  return false;
}

// The words unix and linux are macros of GNU cpp.
bool HasPredefined(std::string_view text) {
  for (size_t at = text.find('x'); at != std::string_view::npos; at = text.find('x', at + 1)) {
    const std::string_view before = text.substr(0, at);
    if (before.ends_with("uni") || before.ends_with("linu")) return true;
  }
  return false;
}

}  // namespace

bool PreprocessorMatters(std::string_view piece) {
  if (piece.starts_with("\xef\xbb\xbf")) return true;  // a byte order mark, which cpp drops
  for (const char c : {'#', '\r', '\f', '\\'}) {
    if (std::memchr(piece.data(), c, piece.size())) return true;
  }
  // "//" is a comment, "__" and "_P" may begin a name that cpp knows, "%:" is another way to write
  // #.
  return HasPair(piece, '/', "/") || HasPair(piece, '_', "_P") || HasPair(piece, '%', ":") ||
         HasPredefined(piece);
}

std::vector<std::string> SplitWords(const std::vector<std::string>& arguments) {
  std::vector<std::string> words;
  for (const std::string& argument : arguments) {
    std::istringstream text(argument);
    for (std::string word; text >> word;) words.push_back(word);
  }
  return words;
}

int Preprocessor::Start(const std::vector<std::string>& arguments, const std::string& file) {
  std::vector<std::string> words{"cpp"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  if (!file.empty()) words.push_back(file);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return errno;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const int error = posix_spawnp(&process_, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  output_ = ends[0];
  if (error) process_ = -1;
  return error;
}

bool Preprocessor::Finish() {
  if (output_ >= 0) close(output_);
  output_ = -1;
  if (process_ < 0) return true;
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

Preprocessor::~Preprocessor() { Finish(); }

}  // namespace rayshade
