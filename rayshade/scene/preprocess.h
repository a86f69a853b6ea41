// The C preprocessor in front of the parser [rayshade4/1 s.2.2]. It is started without a shell, and
// not at all where it could change nothing.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

namespace rayshade {

// Could a GNU preprocessor turn this text into another? May say yes where the answer is no. Texts
// are looked at in pieces that overlap by kPieceOverlap bytes.
bool PreprocessorMatters(std::string_view piece);
inline constexpr size_t kPieceOverlap = 8;

// The arguments of -P may hold several words in one.
std::vector<std::string> SplitWords(const std::vector<std::string>& arguments);

// A running cpp.
class Preprocessor {
 public:
  ~Preprocessor();
  // file: "": its standard input is ours. Returns 0, or the error number of what could not be done.
  int Start(const std::vector<std::string>& arguments, const std::string& file);
  int output() const { return output_; }  // what it writes, a descriptor
  // After the end of the output: did it succeed?
  bool Finish();

 private:
  int output_ = -1;
  pid_t process_ = -1;
};

}  // namespace rayshade
