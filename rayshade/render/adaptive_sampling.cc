// Rayshade's sampling rule as a state machine; see adaptive_sampling.h.
#include "rayshade/render/adaptive_sampling.h"

#include <algorithm>

#include "rayshade/common/check.h"
#include "rayshade/render/pixel_filter.h"
#include "rayshade/render/saved_bytes.h"

namespace rayshade {

AdaptiveSampling::AdaptiveSampling(const Settings& settings, const Camera& camera, bool ahead,
                                   Picture* picture)
    : settings_(settings),
      camera_(camera),
      ahead_(ahead),
      picture_(picture),
      width_(picture->width()),
      height_(picture->height()),
      cells_(settings.samples * settings.samples),
      weights_(FilterWeights(settings)),
      extra_row_(width_),
      flags_(size_t(width_) * (height_ + 1)),
      slots_(flags_.size()),
      singles_missing_(height_ + 1, width_),
      walk_(width_, 1, height_ + 1),
      open_(height_ + 1) {
  if (ahead) unsettled_.resize(height_ + 1);
  singles_missing_[0] = 0;
  for (int x = 0; x < width_; ++x) AskFull(x, 0);
}

std::vector<Sample> AdaptiveSampling::Next(size_t most) {
  std::vector<Sample> samples;
  for (;;) {
    if (news_) Replay();
    if (pixels_.done()) AskBorder();
    if (ahead_ && walk_.done() && asks_.size() * cells_ < most) {
      const bool stuck = !asks_.empty() && samples_handed_ - samples_put_ < 4 * most;
      Guess();
      if (stuck && asks_.size() * cells_ < most) LookAhead(most);
    }
    if (!asks_.empty()) {
      HandOutFull(most, &samples);
      break;
    }
    if (pixels_.done() && walk_.done()) break;
    HandOutSingles(most, &samples);
    if (!samples.empty()) break;  // a tile may be known already
  }
  samples_handed_ += samples.size();
  return samples;
}

void AdaptiveSampling::Put(const Sample& sample, const RayResult& result) {
  ++samples_put_;
  const PixelValue put{result.color, result.hit ? 1.0 : 0.0, false};
  bool news = false;
  if (sample.single) {
    value(sample.x, sample.y) = put;
    flags_[index(sample.x, sample.y)] |= kSingle;
    news = --singles_missing_[sample.y] == 0;
    if (ahead_) Unsettle(sample.x, sample.y);
  } else {
    CHECK(is(sample.x, sample.y, kAsked) && !is(sample.x, sample.y, kFull));
    FullSet& set = set_of(sample.x, sample.y);
    set.results[sample.sub_cell] = put;
    news = --set.missing == 0;
    if (ahead_ && news) Unsettle(sample.x, sample.y);
  }
  news_ |= news;
  // Near the end nobody may call Next any more.
  const bool nothing_left = walk_.done() && asks_.empty();
  if (news_ && (nothing_left || samples_put_ == samples_handed_)) Replay();
}

// Asking

void AdaptiveSampling::AskFull(int x, int y) {
  if (is(x, y, kAsked) || is(x, y, kFull)) return;
  flags_[index(x, y)] |= kAsked;
  if (free_sets_.empty()) {
    free_sets_.push_back(static_cast<uint32_t>(sets_.size()));
    sets_.emplace_back();
  }
  slots_[index(x, y)] = free_sets_.back();
  free_sets_.pop_back();
  FullSet& set = set_of(x, y);
  set.valued = false;
  set.missing = y == 0 ? cells_ : cells_ - 1;
  set.results.resize(cells_);
  asked_samples_ += set.missing;
  open_[y] += set.missing;
  asks_.push_back({x, y, 0});
}

// The ends of rows whose singles are handed out, and the last row once all are.
void AdaptiveSampling::AskBorder() {
  for (; border_rows_ < walk_.rows_begun(); ++border_rows_) {
    AskFull(0, border_rows_);
    AskFull(width_ - 1, border_rows_);
  }
  if (!walk_.done() || last_row_asked_) return;
  last_row_asked_ = true;
  for (int x = 1; x < width_ - 1; ++x) AskFull(x, height_ - 1);
}

void AdaptiveSampling::HandOutFull(size_t most, std::vector<Sample>* samples) {
  while (!asks_.empty()) {
    Ask& ask = asks_.front();
    const int single = ask.y == 0 ? -1 : camera_.SingleSubCell(ask.x, ask.y);
    for (; ask.sub_cell < cells_; ++ask.sub_cell) {
      if (ask.sub_cell == single) continue;
      if (samples->size() == most) return;
      samples->push_back({ask.x, ask.y, static_cast<uint16_t>(ask.sub_cell), false});
    }
    asks_.pop_front();
  }
}

void AdaptiveSampling::HandOutSingles(size_t most, std::vector<Sample>* samples) {
  if (pixels_.done()) pixels_ = TilePixels(walk_.Next(most));
  for (; !pixels_.done() && samples->size() < most; pixels_.Next()) {
    const int x = pixels_.x(), y = pixels_.y();
    if (!is(x, y, kSingle)) samples->push_back({x, y, camera_.SingleSubCell(x, y), true});
  }
}

// Full sets

// The value of a full set, or null while results are missing.
const PixelValue* AdaptiveSampling::FullValue(int x, int y) {
  if (!is(x, y, kAsked) || is(x, y, kFull)) return nullptr;
  FullSet& set = set_of(x, y);
  if (set.valued) return &set.value;
  if (set.missing > 0 || (y > 0 && !is(x, y, kSingle))) return nullptr;

  // The single sample first, then the others in the order of sub-cells.
  const int single = y == 0 ? -1 : camera_.SingleSubCell(x, y);
  PixelValue sum;
  const auto add = [&sum](const PixelValue& v, double weight) {
    sum.color += v.color * weight;
    sum.alpha += v.alpha * weight;
  };
  if (single >= 0) {
    const PixelValue& first = value(x, y);
    sum = {first.color * weights_[single], first.alpha * weights_[single]};
  }
  for (int i = 0; i < cells_; ++i) {
    if (i != single) add(set.results[i], weights_[i]);
  }
  sum.full = true;
  set.value = sum;
  set.valued = true;
  return &set.value;
}

// REQUIRES: FullValue(x, y), or applied already.
void AdaptiveSampling::ApplyFull(int x, int y) {
  if (is(x, y, kFull)) return;
  const PixelValue* full = FullValue(x, y);
  CHECK(full != nullptr);
  value(x, y) = *full;
  flags_[index(x, y)] |= kFull;
  free_sets_.push_back(slots_[index(x, y)]);
  ++supersampled_;
  const int samples = y == 0 ? cells_ : cells_ - 1;
  applied_samples_ += samples;
  open_[y] -= samples;
}

// Replay

void AdaptiveSampling::Replay() {
  news_ = false;
  while (!done_) {
    if (entered_ <= std::min(row_ + 1, height_)) {
      if (!EnterRow(entered_)) return;
      ++entered_;
    } else if (row_ < height_) {
      if (!RefineRow(row_)) return;
      ++row_;
      in_vain_ += open_[row_ - 2];
      decided_ = applied_samples_ + in_vain_;
    } else {
      if (!FinishLastRow()) return;
      done_ = true;
    }
  }
}

bool AdaptiveSampling::EnterRow(int y) {
  if (singles_missing_[y] > 0) return false;
  const int step = y == 0 ? 1 : std::max(1, width_ - 1);
  for (int x = 0; x < width_; x += step) {
    if (!is(x, y, kFull) && FullValue(x, y) == nullptr) return false;
  }
  for (int x = 0; x < width_; x += step) ApplyFull(x, y);
  return true;
}

// Goes on at x_; returns false where a full set has to be waited for.
bool AdaptiveSampling::RefineRow(int y) {
  for (;;) {
    for (; x_ < width_ - 1; ++x_) {
      const Cross cross = CrossAt(x_, y);
      const Color* colors[5];
      bool all_full = true;
      for (int i = 0; i < 5; ++i) {
        colors[i] = &value(cross.x[i], cross.y[i]).color;
        all_full &= is(cross.x[i], cross.y[i], kFull);
      }
      if (all_full || !Fires(colors)) continue;

      bool known = true;
      for (int i = 0; i < 5; ++i) {
        if (is(cross.x[i], cross.y[i], kFull)) continue;
        AskFull(cross.x[i], cross.y[i]);
        known &= FullValue(cross.x[i], cross.y[i]) != nullptr;
      }
      if (!known) return false;
      for (int i = 0; i < 5; ++i) ApplyFull(cross.x[i], cross.y[i]);
      pass_changed_ = true;
    }
    x_ = 1;
    if (!pass_changed_) return true;
    pass_changed_ = false;
  }
}

// The pixels of the last row that no test made full; of a picture of one row, all are.
bool AdaptiveSampling::FinishLastRow() {
  const int y = height_ - 1;
  for (int x = 1; x < width_ - 1; ++x) {
    if (!is(x, y, kFull) && FullValue(x, y) == nullptr) return false;
  }
  for (int x = 1; x < width_ - 1; ++x) ApplyFull(x, y);
  return true;
}

// Half of the work is thought to be in the singles.
double AdaptiveSampling::fraction_done() const {
  const double rows = height_;
  return .5 * (walk_.rows_begun() - 1) / rows + .5 * rows_done() / rows;
}

// Cutting short and going on: values, and where the replay stands. Full sets under way are
// forgotten.

std::string AdaptiveSampling::Save() const {
  ByteWriter out;
  out.Put(row_);
  out.Put(x_);
  out.Put(entered_);
  out.Put(static_cast<uint8_t>(pass_changed_));
  out.Put(supersampled_);
  const int rows = std::max(rows_restored_, walk_.rows_begun());
  out.Put(rows);
  for (size_t i = 0; i < index(0, rows); ++i) {
    out.Put(static_cast<uint8_t>(flags_[i] & (kSingle | kFull)));
  }
  for (int y = 0; y < rows; ++y) out.PutRow(&value(0, y), width_);
  return out.bytes();
}

bool AdaptiveSampling::Restore(const std::string& bytes) {
  ByteReader in(bytes);
  const int row = in.Get<int>(), x = in.Get<int>(), entered = in.Get<int>();
  if (row < 1 || row > height_ || x < 1 || x > std::max(width_, 1) || entered < 0 ||
      entered > height_ + 1) {
    return false;
  }
  const uint8_t pass_changed = in.Get<uint8_t>();
  const uint64_t supersampled = in.Get<uint64_t>();
  const int rows = in.Get<int>();
  if (rows < 1 || rows > height_ + 1) return false;
  if (!in.Holds(index(0, rows) * (1 + kSavedPixelBytes))) return false;

  rows_restored_ = rows;
  row_ = row;
  x_ = x;
  entered_ = entered;
  pass_changed_ = pass_changed != 0;
  supersampled_ = supersampled;
  asks_.clear();
  sets_.clear();
  free_sets_.clear();
  asked_samples_ = 0;
  std::fill(open_.begin(), open_.end(), 0);
  std::fill(flags_.begin(), flags_.end(), uint8_t{0});
  for (size_t i = 0; i < index(0, rows); ++i) flags_[i] = in.Get<uint8_t>() & (kSingle | kFull);
  for (int y = 0; y <= height_; ++y) {
    if (y < rows) in.GetRow(&value(0, y), width_);
    singles_missing_[y] = 0;
    for (int i = 0; i < width_ && y > 0; ++i) singles_missing_[y] += !is(i, y, kSingle);
    for (int i = 0; i < width_ && ahead_; ++i) Unsettle(i, y);
  }
  for (int i = 0; i < width_; ++i) AskFull(i, 0);
  news_ = true;
  return true;
}

}  // namespace rayshade
