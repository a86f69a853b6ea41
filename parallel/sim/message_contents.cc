// See message_contents.h.
#include "parallel/sim/message_contents.h"

namespace rayshade::parallel {

namespace {

// Calls visit with the decoded message.
template <class Visit>
void Open(std::span<const uint8_t> bytes, const Visit& visit) {
  const Tag tag = TagOf(bytes);
  ForEachMessage([&]<class Message>() {
    if (Message::kTag == tag) visit(Decode<Message>(bytes));
  });
}

// "3 rays" and the like, behind what is there already.
void Add(size_t n, const char* one, const char* many, std::string* text) {
  if (n == 0) return;
  if (!text->empty()) *text += ", ";
  *text += std::to_string(n) + " " + (n == 1 ? one : many);
}

struct Addresses {
  ProcessId to;
  RaysOfMessage* rays;

  void Finished(uint64_t token) const { rays->finished.push_back({to, token}); }

  template <class Message>
  void operator()(const Message&) const {}
  void operator()(const PrimaryRays& m) const {
    for (const uint64_t token : m.samples.tokens()) rays->travelling.push_back({kHost, token});
  }
  void operator()(const TravellingRays& m) const {
    for (const PrimaryTravel& p : m.primary) rays->travelling.push_back({kHost, p.token});
    for (const Travel& t : m.travel) rays->travelling.push_back(t.back);
  }
  void operator()(const RayTask& m) const { (*this)(static_cast<const TravellingRays&>(m)); }
  void operator()(const IntersectionTask& m) const {
    (*this)(static_cast<const TravellingRays&>(m));
  }
  void operator()(const RayResults& m) const {
    for (const ResultItem& r : m.results) Finished(r.token);
  }
  void operator()(const PixelResults& m) const {
    for (const uint64_t token : m.voids.tokens()) Finished(token);
    for (const PixelItem& p : m.misses) Finished(p.token);
    for (const PixelItem& p : m.hits) Finished(p.token);
  }
  void operator()(const ShadowTask& m) const {
    for (const ShadowTravel& s : m.rays) rays->shadows_travelling.push_back(s.back);
  }
  void operator()(const ShadowResults& m) const {
    for (const ShadowItem& s : m.results) rays->shadows_finished.push_back({to, s.token});
  }
};

struct Words {
  std::string* text;

  template <class Message>
  void operator()(const Message&) const {}
  void operator()(const ObjectParcel& p) const {
    Add(p.objects.size(), "object", "objects", text);
    Add(p.placements.size(), "placement", "placements", text);
    Add(p.images.size(), "image", "images", text);
  }
  void operator()(const Objects& m) const { (*this)(m.parcel); }
  void operator()(const SetUp& m) const { Add(m.tree.size(), "cell", "cells", text); }
  void operator()(const PrimaryRays& m) const {
    Add(m.samples.size(), "primary ray", "primary rays", text);
  }
  void Travelling(const TravellingRays& m, const char* one, const char* many) const {
    Add(m.primary.size(), ("primary " + std::string(one)).c_str(),
        ("primary " + std::string(many)).c_str(), text);
    Add(m.travel.size(), ("secondary " + std::string(one)).c_str(),
        ("secondary " + std::string(many)).c_str(), text);
  }
  void operator()(const RayTask& m) const { Travelling(m, "ray", "rays"); }
  void operator()(const IntersectionTask& m) const { Travelling(m, "hit", "hits"); }
  void operator()(const RayResults& m) const { Add(m.results.size(), "result", "results", text); }
  void operator()(const PixelResults& m) const {
    Add(m.misses.size() + m.hits.size(), "pixel", "pixels", text);
    Add(m.voids.size(), "void", "voids", text);
  }
  void operator()(const ShadowTask& m) const {
    Add(m.rays.size(), "shadow ray", "shadow rays", text);
  }
  void operator()(const ShadowResults& m) const {
    Add(m.results.size(), "shadow result", "shadow results", text);
  }
  void operator()(const CellRequest& m) const { *text = "cell " + std::to_string(m.cell); }
  void operator()(const CellReply& m) const {
    *text = "cell " + std::to_string(m.cell);
    (*this)(m.parcel);
  }
  void operator()(const Failure& m) const { *text = m.text; }
};

}  // namespace

RaysOfMessage RaysOf(std::span<const uint8_t> message, ProcessId to) {
  RaysOfMessage rays;
  Open(message, Addresses{to, &rays});
  return rays;
}

std::string ContentsOf(std::span<const uint8_t> message) {
  std::string text;
  Open(message, Words{&text});
  return text;
}

}  // namespace rayshade::parallel
