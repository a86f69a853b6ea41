// The reserved words of the language, synonyms included [rayshade4/1 s.1.10].
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace rayshade {

// What a word may begin; where reading goes on after a syntax error.
enum class WordRole : uint8_t {
  kInside,    // nothing: it stands inside an item
  kItem,      // an item of the file
  kBodyItem,  // an item of the file or of an aggregate
  kEnd,       // closes an aggregate
};

struct Keyword {
  std::string_view text;
  int token;  // of the grammar; synonyms share one
  WordRole role;
};

std::span<const Keyword> Keywords();

}  // namespace rayshade
