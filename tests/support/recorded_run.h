// A run in one address space with every message written down, for tests of who says what to whom.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "parallel/cell_tree.h"
#include "parallel/message.h"
#include "parallel/process.h"
#include "parallel/run_options.h"
#include "rayshade/image/picture.h"
#include "rayshade/render/camera.h"

namespace rayshade::parallel {

struct SentMessage {
  ProcessId from = kHost, to = kHost;
  Tag tag = Tag::kStop;
  std::vector<uint8_t> bytes;
};

// Keeps what is sent to it, in order.
class RecordingOutbox : public Outbox {
 public:
  RecordingOutbox(ProcessId from, std::vector<SentMessage>* sent) : from_(from), sent_(sent) {}
  void Send(ProcessId to, std::vector<uint8_t> bytes) override {
    sent_->push_back({from_, to, TagOf(bytes), std::move(bytes)});
  }

 private:
  ProcessId from_;
  std::vector<SentMessage>* sent_;
};

// A ray on its way from process to process.
struct Traveller {
  Ray ray;
  Travel travel;
};

// A primary ray's result in a PixelResults.
struct Pixel {
  uint64_t token = 0;
  Color color;
  bool hit = false;
};

struct RecordedRun {
  std::vector<SentMessage> sent;  // in order of sending; copies of the same message share nothing
  CellTree tree;
  std::unique_ptr<Camera> camera;
  Picture picture{0, 0};
  std::vector<Statistics> processes;
  uint32_t in_flight_limit = 0;

  // Calls visit(sent, message) for every message of one kind, in order.
  template <class Message, class Visit>
  void ForEach(Visit visit) const {
    for (const SentMessage& s : sent) {
      if (s.tag == Message::kTag) visit(s, Decode<Message>(s.bytes));
    }
  }
  size_t Count(Tag tag) const;
  // The rays of a RayTask or an IntersectionTask, and the pixels of a PixelResults; of other
  // messages none.
  std::vector<Traveller> Travellers(const SentMessage& message) const;
  static std::vector<Pixel> Pixels(const SentMessage& message);
  // The cell that a hit at this distance lies in is this process's; kHost: outside of the tree.
  ProcessId OwnerAt(const Ray& ray, double distance) const;
};

// seed: order of events. Throws what the run throws.
RecordedRun RecordRun(const std::string& text, const RunOptions& options, uint64_t seed);

}  // namespace rayshade::parallel
