// THE CATALOGUE: every message between the processes of a run, with who sends it to whom and the
// part of the paper it belongs to: the arrows of figure 5. doc/messages.md is printed from it.
//
//   1. A message is: its tag (one byte), then its fields in order (wire.h). Nothing follows.
//   2. Tags are never reused.
//   3. Messages hold values; what is done with them stands in host_process.cc and trace_*.cc, one
//   handler each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "parallel/cell_tree.h"
#include "parallel/message_parts.h"
#include "parallel/process_id.h"
#include "parallel/run_options.h"
#include "parallel/scene_codec.h"
#include "parallel/wire.h"
#include "rayshade/common/op_counts.h"

namespace rayshade::parallel {

enum class Tag : uint8_t {
  kSetUp = 1,
  kObjects = 2,
  kObjectsTaken = 3,
  kDistributed = 4,
  kReady = 5,
  kWorkRequest = 6,
  kPrimaryRays = 7,
  kRayTask = 8,
  kIntersectionTask = 9,
  kRayResults = 10,
  kPixelResults = 11,
  kCellRequest = 12,
  kCellReply = 13,
  kStop = 14,
  kStatistics = 15,
  kText = 16,
  kFailure = 17,
  kShadowTask = 18,
  kShadowResults = 19,
};
inline constexpr int kTags = 20;  // one more than the greatest tag

// Each message: kTag, kName, kFrom, kTo, kSection, kMeaning, fields.
#define RAYSHADE_MESSAGE(Name, From, To, Section, Meaning) \
  static constexpr Tag kTag = Tag::k##Name;                \
  static constexpr const char* kName = #Name;              \
  static constexpr const char* kFrom = From;               \
  static constexpr const char* kTo = To;                   \
  static constexpr const char* kSection = Section;         \
  static constexpr const char* kMeaning = Meaning

struct SetUp {
  RAYSHADE_MESSAGE(
      SetUp, "host", "trace", "RJ s.4, figure 4",
      "Everything but objects: scene, subdivision, options. Drops what an earlier frame left.");
  ProcessId id = 1;  // the receiver's own
  int32_t frame = 0;
  RunOptions options;
  SceneSpec scene;               // without placements and images
  std::vector<uint32_t> images;  // number of each texture's image: image_table.h
  bool any_transparent =
      false;  // of the whole scene: shadow rays have to be followed through objects
  CellTree tree;

  template <class A>
  void Fields(A& a) {
    a("id", id);
    a("frame", frame);
    a("options", options);
    a("scene", scene);
    a("images", images);
    a("any_transparent", any_transparent);
    a("tree", tree);
  }
};

struct Objects {
  RAYSHADE_MESSAGE(Objects, "host", "trace", "RJ s.2, s.4",
                   "Objects of the receiver's own cells and of the resident set.");
  ObjectParcel parcel;

  template <class A>
  void Fields(A& a) {
    a("parcel", parcel);
  }
};

struct ObjectsTaken {
  RAYSHADE_MESSAGE(ObjectsTaken, "trace", "host", "",
                   "One Objects message is stored: flow control.");
  template <class A>
  void Fields(A&) {}
};

struct Distributed {
  RAYSHADE_MESSAGE(Distributed, "host", "trace", "RJ s.2",
                   "The last objects are sent: build the hierarchy.");
  template <class A>
  void Fields(A&) {}
};

struct Ready {
  RAYSHADE_MESSAGE(Ready, "trace", "host", "RJ s.6 (o.m.)",
                   "Objects are in place; whether memory suffices for them and for the two largest "
                   "cells of others.");
  uint64_t bytes_held = 0;
  uint64_t bytes_needed = 0;
  uint64_t probe = 0;  // hash of mathematical functions' values: processes must agree bit for bit
  std::string machine;

  template <class A>
  void Fields(A& a) {
    a("bytes_held", bytes_held);
    a("bytes_needed", bytes_needed);
    a("probe", probe);
    a("machine", machine);
  }
};

struct WorkRequest {
  RAYSHADE_MESSAGE(WorkRequest, "trace", "host", "RJ s.4",
                   "A process short of work asks for pyramids of primary rays.");
  template <class A>
  void Fields(A&) {}
};

struct PrimaryRays {
  RAYSHADE_MESSAGE(PrimaryRays, "host", "trace", "RJ s.3-4",
                   "Pyramids of primary rays, as runs of samples of the picture: PyraClip tasks.");
  SampleRuns samples;

  template <class A>
  void Fields(A& a) {
    a("samples", samples);
  }
};

struct RayTask : TravellingRays {
  RAYSHADE_MESSAGE(RayTask, "host, trace", "trace", "RJ s.2",
                   "Rays that go on in a cell of the receiver's, with their best hits so far.");
};

struct IntersectionTask : TravellingRays {
  RAYSHADE_MESSAGE(IntersectionTask, "trace", "trace", "RJ s.4",
                   "Hits for the process that keeps the object: it spawns, gathers and shades. "
                   "Best hit = the hit.");
};

// One finished ray.
struct ResultItem {
  static constexpr bool kPacked = true;
  uint64_t token = 0;
  Color color;
  double distance = 0;  // kFar: nothing was hit

  template <class A>
  void Fields(A& a) {
    a("token", token);
    a("color", color);
    a("distance", distance);
  }
};

struct RayResults {
  RAYSHADE_MESSAGE(RayResults, "trace", "trace", "RJ s.2",
                   "Results of secondary rays, back to the process that spawned them.");
  std::vector<ResultItem> results;

  template <class A>
  void Fields(A& a) {
    a("results", results);
  }
};

// A finished primary ray and its colour.
struct PixelItem {
  static constexpr bool kPacked = true;
  uint64_t token = 0;
  Color color;

  template <class A>
  void Fields(A& a) {
    a("token", token);
    a("color", color);
  }
};

struct PixelResults {
  RAYSHADE_MESSAGE(
      PixelResults, "trace", "host", "RJ s.2, s.4",
      "Results of primary rays: hits, misses that the air has coloured, and voids, which show the "
      "background and are told as runs of samples.");
  SampleRuns voids;
  std::vector<PixelItem> misses, hits;

  template <class A>
  void Fields(A& a) {
    a("voids", voids);
    a("misses", misses);
    a("hits", hits);
  }
};

struct CellRequest {
  RAYSHADE_MESSAGE(CellRequest, "trace", "trace", "RJ s.3, figure 3",
                   "Asks the owner for the objects of a cell.");
  CellId cell = 0;

  template <class A>
  void Fields(A& a) {
    a("cell", cell);
  }
};

struct CellReply {
  RAYSHADE_MESSAGE(CellReply, "trace", "trace", "RJ s.3, figure 3",
                   "The objects of a cell, for the receiver's cache.");
  CellId cell = 0;
  ObjectParcel parcel;

  template <class A>
  void Fields(A& a) {
    a("cell", cell);
    a("parcel", parcel);
  }
};

struct Stop {
  RAYSHADE_MESSAGE(Stop, "host", "trace", "", "The picture is complete: report and end.");
  template <class A>
  void Fields(A&) {}
};

struct KindCount {
  std::string name;  // of a message
  uint64_t messages = 0, bytes = 0;

  template <class A>
  void Fields(A& a) {
    a("name", name);
    a("messages", messages);
    a("bytes", bytes);
  }
};

struct Statistics {
  RAYSHADE_MESSAGE(Statistics, "trace", "host", "RJ s.6",
                   "What the process did, once, at the end.");
  OpCounts counts;
  double busy_seconds = 0;
  double trace_busy_seconds = 0;  // of these, after the objects were stored
  uint64_t peak_bytes = 0;        // of the whole process, as the operating system counts
  uint64_t bytes_held_max = 0;    // of objects, cache and rays in work
  uint64_t objects = 0;
  uint64_t object_bytes = 0;
  uint64_t cache_hits = 0, cache_misses = 0;
  uint64_t demand_rays = 0;     // traced for PyraClip tasks
  uint64_t data_rays = 0;       // traced for RayTasks, ShadowTasks and for rays spawned here
  uint64_t forwarded_rays = 0;  // of these, handed on to another process
  std::vector<KindCount> sent;
  double interval_seconds = 0;
  std::vector<double> busy_by_interval;  // seconds, since the frame began

  template <class A>
  void Fields(A& a) {
    a("counts", counts);
    a("busy_seconds", busy_seconds);
    a("trace_busy_seconds", trace_busy_seconds);
    a("peak_bytes", peak_bytes);
    a("bytes_held_max", bytes_held_max);
    a("objects", objects);
    a("object_bytes", object_bytes);
    a("cache_hits", cache_hits);
    a("cache_misses", cache_misses);
    a("demand_rays", demand_rays);
    a("data_rays", data_rays);
    a("forwarded_rays", forwarded_rays);
    a("sent", sent);
    a("interval_seconds", interval_seconds);
    a("busy_by_interval", busy_by_interval);
  }
};

struct Text {
  RAYSHADE_MESSAGE(Text, "trace", "host", "", "A line for the user.");
  std::string text;

  template <class A>
  void Fields(A& a) {
    a("text", text);
  }
};

struct Failure {
  RAYSHADE_MESSAGE(Failure, "trace", "host", "",
                   "The process cannot go on; the run ends with this error.");
  std::string text;

  template <class A>
  void Fields(A& a) {
    a("text", text);
  }
};

struct ShadowTask {
  RAYSHADE_MESSAGE(
      ShadowTask, "trace", "trace", "RJ s.2",
      "Shadow rays that go on in a cell of the receiver's, with what they have crossed "
      "so far. With --shadows travel.");
  std::vector<ShadowTravel> rays;

  template <class A>
  void Fields(A& a) {
    a("rays", rays);
  }
};

// What arrives of a light.
struct ShadowItem {
  uint64_t token = 0;
  bool arrives = false;
  Color color;

  template <class A>
  void Fields(A& a) {
    a("token", token);
    a("arrives", arrives);
    a("color", color);
  }
};

struct ShadowResults {
  RAYSHADE_MESSAGE(ShadowResults, "trace", "trace", "RJ s.2",
                   "Results of shadow rays, back to the process that spawned them.");
  std::vector<ShadowItem> results;

  template <class A>
  void Fields(A& a) {
    a("results", results);
  }
};

#undef RAYSHADE_MESSAGE

// Calls visit.template operator()<Message>() for every message of the catalogue, in order of tags.
template <class Visit>
void ForEachMessage(Visit&& visit) {
  visit.template operator()<SetUp>();
  visit.template operator()<Objects>();
  visit.template operator()<ObjectsTaken>();
  visit.template operator()<Distributed>();
  visit.template operator()<Ready>();
  visit.template operator()<WorkRequest>();
  visit.template operator()<PrimaryRays>();
  visit.template operator()<RayTask>();
  visit.template operator()<IntersectionTask>();
  visit.template operator()<RayResults>();
  visit.template operator()<PixelResults>();
  visit.template operator()<CellRequest>();
  visit.template operator()<CellReply>();
  visit.template operator()<Stop>();
  visit.template operator()<Statistics>();
  visit.template operator()<Text>();
  visit.template operator()<Failure>();
  visit.template operator()<ShadowTask>();
  visit.template operator()<ShadowResults>();
}

template <class Message>
std::vector<uint8_t> Encode(const Message& message) {
  ByteWriter w;
  w.Put(Message::kTag);
  w.Put(message);
  return w.Take();
}

// The tag of an encoded message; WireError where there is none of that number.
Tag TagOf(std::span<const uint8_t> bytes);
const char* NameOf(Tag tag);

// REQUIRES: TagOf(bytes) == Message::kTag. WireError unless the bytes are exactly one message.
template <class Message>
Message Decode(std::span<const uint8_t> bytes) {
  Message message;
  ByteReader r(bytes.subspan(1));
  r.Get(message);
  r.ExpectEnd();
  return message;
}

// The catalogue as the text of doc/messages.md.
std::string CatalogueText();

}  // namespace rayshade::parallel
