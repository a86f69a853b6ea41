// Full sets that the replay will probably want, so that a parallel run need not wait for one pixel
// after the other; a part of adaptive_sampling.h. Where the replay has not been yet, the rule is
// played with what is known: a test that meets a full set still under way is left until it is in,
// one that fires asks. So every edge of the picture is followed at once, one step with each round
// of results.
#include <algorithm>
#include <array>

#include "rayshade/render/adaptive_sampling.h"

namespace rayshade {
namespace {

constexpr double kSpeculativeShare = .08;  // of all samples in vain; the promise is .1
constexpr double kWasteAtFirst = .05;      // assumed share of guesses in vain, and
constexpr double kWasteWeight = 5000;      // the samples that this assumption counts for

}  // namespace

// Samples that may be guessed now, so that those in vain are expected to stay within their share.
int64_t AdaptiveSampling::GuessesAllowed() const {
  const double in_vain = static_cast<double>(in_vain_), decided = static_cast<double>(decided_);
  const double waste = (in_vain + kWasteAtFirst * kWasteWeight) / (decided + kWasteWeight);
  const double left = kSpeculativeShare * static_cast<double>(samples_handed_) - in_vain;
  const double open = static_cast<double>(asked_samples_ - applied_samples_ - in_vain_);
  return static_cast<int64_t>(left / waste - open);
}

// Something about this pixel has changed: the tests that read it are to be looked at again.
void AdaptiveSampling::Unsettle(int x, int y) {
  for (int row = std::max(y - 1, row_); row <= std::min(y + 1, height_ - 1); ++row) {
    Range& range = unsettled_[row];
    if (range.high < 0) unsettled_rows_.push_back(row);
    range.low = std::min(range.low, x - 1);
    range.high = std::max(range.high, x + 1);
  }
}

void AdaptiveSampling::Guess() {
  std::vector<int> rows;
  rows.swap(unsettled_rows_);
  std::sort(rows.begin(), rows.end());
  const size_t asks_before = asks_.size();
  bool allowed = true;
  for (const int y : rows) {
    const Range range = unsettled_[y];
    unsettled_[y] = {};
    if (y < row_) continue;
    const bool sampled =
        singles_missing_[y - 1] + singles_missing_[y] + singles_missing_[y + 1] == 0;
    allowed = allowed && (!sampled || GuessRow(y, range));
    if (sampled && allowed) continue;

    // Later: singles are still under way, or enough has been guessed for now.
    Range& later = unsettled_[y];
    if (later.high < 0) unsettled_rows_.push_back(y);
    later = {std::min(later.low, range.low), sampled ? width_ : std::max(later.high, range.high)};
  }

  // Neighbours together.
  std::sort(asks_.begin() + asks_before, asks_.end(), [](const Ask& a, const Ask& b) {
    const auto key = [](const Ask& p) { return std::array<int, 4>{p.y / 32, p.x / 32, p.y, p.x}; };
    return key(a) < key(b);
  });
}

// Returns false where the share of speculative samples is used up for now.
bool AdaptiveSampling::GuessRow(int y, Range range) {
  while (range.low <= range.high) {
    Range next;
    for (int x = std::max(1, range.low); x <= std::min(range.high, width_ - 2); ++x) {
      if (!GuessFires(x, y)) continue;
      if (GuessesAllowed() < 5 * cells_) return false;
      const Cross cross = CrossAt(x, y);
      for (int i = 0; i < 5; ++i) {
        flags_[index(cross.x[i], cross.y[i])] |= kExpected;
        AskFull(cross.x[i], cross.y[i]);
        if (cross.y[i] == y + 1 || i == 4) Unsettle(cross.x[i], y + 2);
      }
      next.low = std::min(next.low, x - 2);
      next.high = std::max(next.high, x + 2);
      range.high = std::max(range.high, x + 2);
    }
    range = next;
  }
  return true;
}

// True where the test of a pixel fires on what is known and would ask for something.
bool AdaptiveSampling::GuessFires(int x, int y) {
  const Cross cross = CrossAt(x, y);
  const Color* colors[5];
  bool all_expected = true;
  for (int i = 0; i < 5; ++i) {
    const int cx = cross.x[i], cy = cross.y[i];
    const uint8_t flags = flags_[index(cx, cy)];
    all_expected &= (flags & (kFull | kExpected)) != 0;
    const PixelValue* v = &value(cx, cy);
    if ((flags & kExpected) && !(flags & kFull)) v = FullValue(cx, cy);
    if (v == nullptr) return false;
    colors[i] = &v->color;
  }
  return !all_expected && Fires(colors);
}

// REQUIRES: all singles are in, or the rows that lack them end the search.
void AdaptiveSampling::LookAhead(size_t most) {
  std::vector<uint8_t> full(flags_.begin() + index(0, row_ - 1), flags_.end());
  for (int y = row_; y < height_; ++y) {
    if (singles_missing_[y] + singles_missing_[y + 1] > 0) return;
    if (!LookAheadInRow(y, &full[size_t(y - row_) * width_], most)) return;
  }
}

// full: flags of rows y - 1, y and y + 1 as the rule would have left them. Returns false where
// there is enough to do.
bool AdaptiveSampling::LookAheadInRow(int y, uint8_t* full, size_t most) {
  for (bool changed = true; changed;) {
    changed = false;
    for (int x = 1; x < width_ - 1; ++x) {
      const Cross cross = CrossAt(x, y);
      const Color* colors[5];
      uint8_t* flags[5];
      bool all_full = true;
      for (int i = 0; i < 5; ++i) {
        const int cx = cross.x[i], cy = cross.y[i];
        flags[i] = &full[size_t(cy - y + 1) * width_ + cx];
        const PixelValue* known = (*flags[i] & kFull) ? FullValue(cx, cy) : nullptr;
        colors[i] = known ? &known->color : &value(cx, cy).color;
        all_full &= (*flags[i] & kFull) != 0;
      }
      if (all_full || !Fires(colors)) continue;
      if (asks_.size() * cells_ >= most || GuessesAllowed() < 5 * cells_) return false;
      for (int i = 0; i < 5; ++i) {
        *flags[i] |= kFull;
        AskFull(cross.x[i], cross.y[i]);
      }
      changed = true;
    }
  }
  return true;
}

}  // namespace rayshade
