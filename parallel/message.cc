// Tags, names and the printed catalogue; see message.h.
#include "parallel/message.h"

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
