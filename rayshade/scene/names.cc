// An open hash table of words; see names.h.
#include "rayshade/scene/names.h"

namespace rayshade {
namespace {

uint32_t Hash(std::string_view text) {  // FNV-1a
  uint32_t hash = 2166136261u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash ^ (hash >> 15);
}

}  // namespace

NameTable::NameTable() : slots_(1024) {}

NameId NameTable::Intern(std::string_view text) {
  const uint32_t hash = Hash(text);
  const size_t mask = slots_.size() - 1;
  size_t slot = hash & mask;
  for (; slots_[slot]; slot = (slot + 1) & mask) {
    const Name& name = names_[slots_[slot] - 1];
    if (name.hash == hash && name.text == text) return slots_[slot] - 1;
  }
  names_.push_back({std::string(text), hash});
  slots_[slot] = static_cast<uint32_t>(names_.size());
  if (names_.size() * 2 > slots_.size()) Grow();
  return static_cast<NameId>(names_.size() - 1);
}

void NameTable::Grow() {
  std::vector<uint32_t> slots(slots_.size() * 2);
  const size_t mask = slots.size() - 1;
  for (size_t i = 0; i < names_.size(); ++i) {
    size_t slot = names_[i].hash & mask;
    while (slots[slot]) slot = (slot + 1) & mask;
    slots[slot] = static_cast<uint32_t>(i + 1);
  }
  slots_ = std::move(slots);
}

}  // namespace rayshade
