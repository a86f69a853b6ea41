// One sample per pixel is handled here, in tiles and with nothing kept but the picture [rayshade4/1
// s.8.11]; more than one by AdaptiveSampling. See pixel_sampling.h.
#include "rayshade/render/pixel_sampling.h"

#include <algorithm>

#include "rayshade/render/adaptive_sampling.h"
#include "rayshade/render/saved_bytes.h"
#include "rayshade/render/tile_walk.h"

namespace rayshade {

namespace {

constexpr size_t kAhead = 32;  // samples

}  // namespace

struct PixelSampling::Impl {
  Impl(const Settings& settings, const Camera& camera, bool ahead)
      : camera(camera),
        picture(camera.window().width(), camera.window().height()),
        walk(picture.width(), 0, picture.height() + 1) {
    if (settings.samples > 1) {
      adaptive = std::make_unique<AdaptiveSampling>(settings, this->camera, ahead, &picture);
    } else {
      missing.assign(picture.height() + 1, picture.width());
    }
  }

  std::vector<Sample> NextOfOne(size_t most) {
    std::vector<Sample> samples;
    if (pixels.done()) {
      if (walk.done()) return samples;
      pixels = TilePixels(walk.Next(most));
    }
    samples.resize(std::min(most, pixels.left()));
    for (size_t i = 0; i < samples.size();) {
      const int run = static_cast<int>(std::min<size_t>(pixels.run(), samples.size() - i));
      for (int k = 0; k < run; ++k) samples[i++] = {pixels.x() + k, pixels.y(), 0, pixels.y() > 0};
      pixels.Skip(run);
    }
    return samples;
  }

  // The picture is larger than any cache. Always inline: a function that only fetches counts as one
  // without effect, and calls of it would be left out.
  [[gnu::always_inline]] void Prefetch(const Sample& sample) {
    if (sample.y >= picture.height()) return;
    const auto* const bytes = reinterpret_cast<const char*>(&picture.at(sample.x, sample.y));
    for (size_t at = 0; at < kGroupWidth * sizeof(PixelValue); at += 64) {
      __builtin_prefetch(bytes + at, 1);
    }
  }

  // Samples of one row at a time.
  void PutOfOne(std::span<const Sample> samples, std::span<const RayResult> results) {
    for (size_t begin = 0, end; begin < samples.size(); begin = end) {
      if (begin + kAhead < samples.size()) Prefetch(samples[begin + kAhead]);
      const int y = samples[begin].y;
      for (end = begin; end < samples.size() && samples[end].y == y; ++end) {
        if (y < picture.height()) picture.at(samples[end].x, y) = ValueOf(results[end], y);
      }
      CountPut(y, static_cast<int>(end - begin));
    }
    FindRows();
  }

  void PutRunOfOne(const Sample& first, int count, const RayResult& result) {
    if (first.y < picture.height())
      std::fill_n(&picture.at(first.x, first.y), count, ValueOf(result, first.y));
    CountPut(first.y, count);
    FindRows();
  }

  static PixelValue ValueOf(const RayResult& result, int y) {
    return {result.color, result.hit ? 1.0 : 0.0, y == 0};
  }
  void CountPut(int y, int count) {
    put += count;
    missing[y] -= count;
  }
  void FindRows() {
    while (rows < static_cast<int>(missing.size()) && missing[rows] == 0) ++rows;
  }

  // Complete rows.
  std::string SaveOfOne() const {
    ByteWriter out;
    const int whole = std::min(rows, picture.height());
    out.Put(whole);
    for (int y = 0; y < whole; ++y) out.PutRow(&picture.at(0, y), picture.width());
    return out.bytes();
  }

  bool RestoreOfOne(const std::string& bytes) {
    ByteReader in(bytes);
    if (!in.Holds(sizeof(int))) return false;
    const int whole = in.Get<int>();
    if (whole < 0 || whole > picture.height()) return false;
    if (!in.Holds(uint64_t(whole) * picture.width() * kSavedPixelBytes)) return false;
    for (int y = 0; y < whole; ++y) {
      in.GetRow(&picture.at(0, y), picture.width());
      missing[y] = 0;
    }
    rows = whole;
    put = uint64_t(whole) * picture.width();
    walk = TileWalk(picture.width(), whole, picture.height() + 1);
    return true;
  }

  // The border counts as supersampled although it costs nothing; the ends of the extra row as well.
  uint64_t BorderPixels() const {
    const uint64_t w = picture.width(), h = picture.height();
    const uint64_t ends = std::min<uint64_t>(w, 2) * h;
    return w + ends + (h > 1 && w > 2 ? w - 2 : 0);
  }

  Camera camera;
  Picture picture;
  std::unique_ptr<AdaptiveSampling> adaptive;  // null: one sample per pixel
  TileWalk walk;
  TilePixels pixels;         // of the tile at hand, from the next one on
  std::vector<int> missing;  // samples by row, the extra row included
  int rows = 0;              // complete rows from the top, the extra row included
  uint64_t put = 0;          // samples
};

PixelSampling::PixelSampling(const Settings& settings, const Camera& camera, bool ahead)
    : impl_(std::make_unique<Impl>(settings, camera, ahead)) {}
PixelSampling::~PixelSampling() = default;

std::vector<Sample> PixelSampling::Next(size_t most) {
  return impl_->adaptive ? impl_->adaptive->Next(most) : impl_->NextOfOne(most);
}

void PixelSampling::Put(const Sample& sample, const RayResult& result) {
  Put({&sample, 1}, {&result, 1});
}

void PixelSampling::Put(std::span<const Sample> samples, std::span<const RayResult> results) {
  if (impl_->adaptive) {
    for (size_t i = 0; i < samples.size(); ++i) impl_->adaptive->Put(samples[i], results[i]);
  } else {
    impl_->PutOfOne(samples, results);
  }
}

void PixelSampling::PutRun(const Sample& first, int count, const RayResult& result) {
  if (!impl_->adaptive) return impl_->PutRunOfOne(first, count, result);
  Sample sample = first;
  for (const int end = first.x + count; sample.x < end; ++sample.x)
    impl_->adaptive->Put(sample, result);
}

bool PixelSampling::done() const {
  return impl_->adaptive ? impl_->adaptive->done() : impl_->rows > impl_->picture.height();
}
int PixelSampling::rows_done() const {
  return impl_->adaptive ? impl_->adaptive->rows_done()
                         : std::min(impl_->rows, impl_->picture.height());
}
double PixelSampling::fraction_done() const {
  const Impl& m = *impl_;
  if (m.adaptive) return m.adaptive->fraction_done();
  return double(m.put) / (double(m.picture.width()) * (m.picture.height() + 1));
}
const Picture& PixelSampling::picture() const { return impl_->picture; }
uint64_t PixelSampling::supersampled_pixels() const {
  return impl_->adaptive ? impl_->adaptive->supersampled_pixels() : impl_->BorderPixels();
}
uint64_t PixelSampling::speculative_samples() const {
  return impl_->adaptive ? impl_->adaptive->speculative_samples() : 0;
}

std::string PixelSampling::Save() const {
  return impl_->adaptive ? impl_->adaptive->Save() : impl_->SaveOfOne();
}
bool PixelSampling::Restore(const std::string& bytes) {
  return impl_->adaptive ? impl_->adaptive->Restore(bytes) : impl_->RestoreOfOne(bytes);
}

}  // namespace rayshade
