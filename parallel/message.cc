// Tags, names and the printed catalogue; see message.h.
#include "parallel/message.h"

#include <set>

namespace rayshade::parallel {

namespace {

// An archive that writes down the names of the fields instead of their values.
struct FieldNames {
  static constexpr bool kReading = false;
  std::string text;

  template <class T>
  void operator()(const char* name, T&) {
    if (!text.empty()) text += ", ";
    text += name;
  }
};

}  // namespace

Tag TagOf(std::span<const uint8_t> bytes) {
  if (bytes.empty()) throw WireError("an empty message");
  bool known = false;
  ForEachMessage(
      [&]<class Message>() { known = known || bytes[0] == static_cast<uint8_t>(Message::kTag); });
  if (!known) throw WireError("a message of an unknown kind");
  return static_cast<Tag>(bytes[0]);
}

const char* NameOf(Tag tag) {
  const char* name = "?";
  ForEachMessage([&]<class Message>() {
    if (Message::kTag == tag) name = Message::kName;
  });
  return name;
}

uint64_t TokenOf(const Sample& sample) {
  return static_cast<uint64_t>(static_cast<uint32_t>(sample.x) & 0xffffff) |
         static_cast<uint64_t>(static_cast<uint32_t>(sample.y) & 0xffffff) << 24 |
         static_cast<uint64_t>(sample.sub_cell & 0xff) << 48 |
         static_cast<uint64_t>(sample.single) << 56;
}

Sample SampleOf(uint64_t token) {
  Sample s;
  s.x = static_cast<int32_t>(token & 0xffffff);
  s.y = static_cast<int32_t>(token >> 24 & 0xffffff);
  s.sub_cell = static_cast<uint16_t>(token >> 48 & 0xff);
  s.single = (token >> 56 & 1) != 0;
  return s;
}

std::string CatalogueText() {
  std::string text =
      "# Messages\n\n"
      "Printed from parallel/message.h by `make doc`; a test compares the two. A message is its "
      "tag (one byte) and "
      "its fields in order; numbers are little-endian, lists carry their count.\n\n"
      "| tag | message | from | to | paper | fields | meaning |\n| --- | --- | --- | --- | --- | "
      "--- | --- |\n";
  ForEachMessage([&]<class Message>() {
    Message message;
    FieldNames fields;
    message.Fields(fields);
    text += "| " + std::to_string(static_cast<int>(Message::kTag)) + " | " + Message::kName +
            " | " + Message::kFrom + " | " + Message::kTo + " | " + Message::kSection + " | " +
            fields.text + " | " + Message::kMeaning + " |\n";
  });
  return text;
}

}  // namespace rayshade::parallel
