// Textures as the scene language writes them [rayshade4/3 s.10-11]; parameters have the language's
// names and order.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "rayshade/common/color.h"
#include "rayshade/common/transform_chain.h"
#include "rayshade/geom/spec.h"

namespace rayshade {

using ColorMap = std::vector<Color>;  // 256 entries
// Bytes of an image, row 0 is the bottom row as seen; channels 1 (grey) or 3, alpha kept apart
// (empty: none).
struct ImageData {
  std::string file;
  int width = 0, height = 0, channels = 3;
  std::vector<uint8_t> color;
  std::vector<uint8_t> alpha;
};

enum class MappingKind : uint8_t { kUv, kPlanar, kCylindrical, kSpherical };
struct MappingSpec {
  MappingKind kind = MappingKind::kUv;
  bool framed = false;  // origin and axes were given
  Vector origin, up, u_axis;
};

struct CheckerSpec {
  SurfaceId surface = kNoSurface;
};
struct BlotchSpec {
  double mix = 0;
  SurfaceId surface = kNoSurface;
};
struct BumpSpec {
  double size = 0;
};
struct GlossSpec {
  double gloss = 0;
};
struct WoodSpec {};
struct MarbleSpec {
  std::shared_ptr<const ColorMap> map;
};
struct FbmSpec {
  double offset = 0, scale = 0, h = 0, lambda = 0;
  int octaves = 0;
  double threshold = 0;
  std::shared_ptr<const ColorMap> map;
};
struct FbmBumpSpec {
  double offset = 0, scale = 0, h = 0, lambda = 0;
  int octaves = 0;
};
struct CloudSpec {
  double scale = 0, h = 0, lambda = 0;
  int octaves = 0;
  double cthresh = 0, lthresh = 0, transcale = 0;
};
struct SkySpec {
  double scale = 0, h = 0, lambda = 0;
  int octaves = 0;
  double cthresh = 0, lthresh = 0;
};
struct StripeSpec {
  SurfaceId surface = kNoSurface;
  double width = 0, bump = 0;
  MappingSpec mapping;
};
struct WindySpec {
  double scale = 0, wave_scale = 0, chop_scale = 0, bump_scale = 0;
  int octaves = 0;
  double tscale = 0, hscale = 0, offset = 0;
};
struct MountSpec {
  std::shared_ptr<const ColorMap> map;
  double turbulence = 0, slope = 0;
};

enum class ImageComponent : uint8_t {
  kAll,
  kAmbient,
  kDiffuse,
  kBody,
  kSpecular,
  kReflect,
  kTransp,
  kSpecpow,
  kBump,
  kIndex
};
struct ImageSpec {
  std::shared_ptr<const ImageData> image;
  ImageComponent component = ImageComponent::kAll;
  double range_low = 0, range_high = 1;
  bool smooth = false;
  SurfaceId surface = kNoSurface;  // textsurf; kNoSurface: none
  double tile_u = 0, tile_v = 0;
  MappingSpec mapping;
};

struct TextureSpec {
  std::variant<CheckerSpec, BlotchSpec, BumpSpec, GlossSpec, WoodSpec, MarbleSpec, FbmSpec,
               FbmBumpSpec, CloudSpec, SkySpec, StripeSpec, WindySpec, MountSpec, ImageSpec>
      kind;
  TransformChain transforms;  // the texture's own
};

}  // namespace rayshade
