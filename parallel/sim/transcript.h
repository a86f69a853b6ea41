// A run as text, one line for each message: when it leaves and when it is there, who sends it to
// whom, its name, what it carries, how many bytes. The same run gives the same bytes.
#pragma once

#include <ostream>

#include "parallel/sim/simulator.h"

namespace rayshade::parallel {

class Transcript : public SimulatorListener {
 public:
  // out: not owned.
  explicit Transcript(std::ostream* out) : out_(out) {}

  // A line that explains what follows.
  void Headline(const std::string& text);
  void OnDepart(const SimulatedMessage& message, double departs, double arrives) override;

 private:
  std::ostream* out_;
};

}  // namespace rayshade::parallel
