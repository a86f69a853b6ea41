// SIGINT and SIGTERM as something to ask for: the first one is remembered, a second one ends the
// program at once. SIGPIPE is ignored from then on: a direct route whose other end is gone must not
// end this process. The one piece of mutable static state, since a signal handler can reach no
// other.
#pragma once

namespace rayshade::parallel {

// While it lives. Signals that the program was started to ignore stay ignored. One at a time.
class Interrupts {
 public:
  Interrupts();
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  // The signal that came, or 0.
  static int Came();
};

}  // namespace rayshade::parallel
