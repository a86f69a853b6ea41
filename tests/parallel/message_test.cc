// Every message goes through bytes unharmed, and bytes that are not a message are an error.
#include "parallel/message.h"

#include <gtest/gtest.h>

#include "parallel/math_probe.h"

namespace rayshade::parallel {
namespace {

// A value for each field, so that every branch of the codec is walked.
template <class Message>
Message Example() {
  Message message;
  if constexpr (requires { message.bundle; }) {
    Ray ray;
    ray.origin = {1, 2, 3};
    ray.direction = {0, 0, 1};
    ray.media_count = 2;
    message.bundle.rays = {ray, Ray()};
    message.bundle.media = {{1.5, .9}, {1.1, .8}};
    message.travel.resize(2);
  }
  if constexpr (requires { message.primary; })
    message.primary = {{7, 1.5, 9, 3}, {8, kFar, kNoRank, kNoCell}};
  if constexpr (requires { message.voids; }) {
    message.voids = {1, 2, 4};
    message.hits = {{7, {1, 2, 3}}, {8, {}}};
    message.misses = {{9, {4, 5, 6}}};
  } else if constexpr (std::is_same_v<Message, ShadowResults>) {
    message.results = {{7, true, {1, 2, 3}}, {8, false, {}}};
  } else if constexpr (requires { message.results; }) {
    message.results = {{7, {1, 2, 3}, 4}, {8, {}, 1e14}};
  }
  if constexpr (std::is_same_v<Message, ShadowTask>) {
    message.rays.resize(2);
    message.rays[0].back = {3, 7};
    message.rays[0].crossings = {{1.5, 9, {1, 2, 3}, .5, true, false}, {}};
  }
  if constexpr (requires { message.samples; }) message.samples = {1, 2, 4};
  if constexpr (requires { message.sent; }) message.sent = {{"RayTask", 3, 4}};
  if constexpr (requires { message.text; }) message.text = "hello";
  if constexpr (requires { message.parcel; }) {
    Placement placement;
    placement.levels.resize(2);
    placement.levels[0].attributes.surface = 3;
    placement.levels[0].attributes.transforms.Append(Translate({1, 2, 3}));
    placement.levels[1].attributes.textures = {1, 2};
    placement.levels[1].clip = Bounds{{0, 0, 0}, {1, 1, 1}};
    placement.Finish();
    message.parcel.placements = {{5, placement}};
    message.parcel.images = {
        {1, std::make_shared<ImageData>(ImageData{"i", 2, 1, 3, {1, 2, 3, 4, 5, 6}, {7, 8}})}};
    const auto members = std::make_shared<std::vector<PlacedSpec>>(2);
    const GeomSpec specs[] = {SphereSpec{2, {1, 2, 3}},
                              BoxSpec{},
                              PlaneSpec{},
                              DiscSpec{},
                              TriangleSpec{},
                              PhongTriangleSpec{},
                              TriangleUvSpec{},
                              PolygonSpec{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, true},
                              CylinderSpec{},
                              ConeSpec{},
                              TorusSpec{},
                              BlobSpec{1, {{1, 2, {3, 4, 5}}}},
                              HeightfieldSpec{"f", 2, std::make_shared<std::vector<float>>(4)},
                              CompositeSpec{AggregateKind::kDifference, {1, 1, 1}, members}};
    uint32_t rank = 0;
    for (const GeomSpec& spec : specs) message.parcel.objects.push_back({rank++, 5, 0, spec});
  }
  if constexpr (requires { message.scene; }) {
    message.scene.surfaces.resize(2);
    message.scene.lights = {{{1, 1, 1}, false, PointLightSpec{{1, 2, 3}}},
                            {{1, 0, 0}, true, SpotLightSpec{}}};
    message.scene.textures = {
        {CheckerSpec{1}, {}}, {ImageSpec{}, {}}, {MarbleSpec{std::make_shared<ColorMap>(256)}, {}}};
    message.scene.atmosphere.effects = {Fog{}, Mist{}, FogDeck{}};
    message.scene.settings.vfov = 30;
    message.tree = CellTree({{0, 0, 0}, {4, 4, 4}});
    message.tree.Cut(0, 1, 2);
  }
  return message;
}

TEST(Messages, GoThroughBytesUnharmed) {
  ForEachMessage([]<class Message>() {
    const std::vector<uint8_t> bytes = Encode(Example<Message>());
    EXPECT_EQ(TagOf(bytes), Message::kTag);
    EXPECT_EQ(Encode(Decode<Message>(bytes)), bytes) << Message::kName;
  });
}

TEST(Messages, TruncatedAtAnyLengthAreErrors) {
  ForEachMessage([]<class Message>() {
    const std::vector<uint8_t> bytes = Encode(Example<Message>());
    for (size_t n = 0; n < bytes.size(); ++n) {
      const std::span<const uint8_t> part(bytes.data(), n);
      EXPECT_THROW(
          {
            TagOf(part);
            Decode<Message>(part);
          },
          WireError)
          << Message::kName << " cut to " << n;
    }
    std::vector<uint8_t> longer = bytes;
    longer.push_back(0);
    EXPECT_THROW(Decode<Message>(longer), WireError) << Message::kName;
  });
}

TEST(Messages, WithAnyByteChangedAreErrorsOrMessages) {
  ForEachMessage([]<class Message>() {
    const std::vector<uint8_t> bytes = Encode(Example<Message>());
    for (size_t i = 1; i < bytes.size(); ++i) {
      for (uint8_t value : {0x00, 0x01, 0x7f, 0xff}) {
        std::vector<uint8_t> changed = bytes;
        changed[i] = value;
        try {
          Decode<Message>(changed);
        } catch (const WireError&) {
        }
      }
    }
  });
}

// Structs that are copied as a whole lie in memory as their fields do on the wire.
TEST(Messages, PackedItemsAreTheirFields) {
  const auto check = []<class Item>(const Item& item) {
    ByteWriter one, many;
    one.Put(uint32_t{1});
    one.Put(item);
    many.Put(std::vector<Item>{item});
    EXPECT_EQ(one.Take(), many.Take());
  };
  check(PrimaryTravel{7, 1.5, 9, 3});
  check(ResultItem{7, {1, 2, 3}, 4});
  check(PixelItem{7, {1, 2, 3}});
}

TEST(Messages, SamplesAreTheirTokens) {
  for (const Sample& s :
       {Sample{0, 0, 0, false}, Sample{511, 512, 63, true}, Sample{100000, 99999, 1, false}}) {
    EXPECT_EQ(SampleOf(TokenOf(s)), s);
  }
}

TEST(MathProbe, IsTheSameEachTime) { EXPECT_EQ(MathProbe(), MathProbe()); }

}  // namespace
}  // namespace rayshade::parallel
