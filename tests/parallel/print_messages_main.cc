// Prints the catalogue of messages: `make doc` writes it to doc/messages.md.
#include <cstdio>

#include "parallel/message.h"

int main() {
  const std::string text = rayshade::parallel::CatalogueText();
  const bool written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  return written ? 0 : 1;
}
