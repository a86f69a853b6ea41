// Sampling of more than one sample per pixel: Rayshade's rule as a state machine [rayshade4/1
// s.8.3-8.10].
//
//   singles  every pixel but those of row 0 gets one sample in a random sub-cell, handed out tile
//   by tile border   row 0, first and last column, at the end the last row get full sets; asked for
//   without waiting replay   goes through rows and pixels in Rayshade's order with what is known;
//   where the contrast test demands
//            the full set of a pixel that is not known, asks for it and stops until it is
//   guess    (ahead only) asks for full sets where the replay will probably want them
//   (sampling_guess.h)
//
//   1. A pixel's value in the picture is what the replay has reached: its single sample, or its
//   full set once applied.
//   2. Full sets that are known but not applied do not show.
//   3. Sub-samples are kept from the asking for a full set until it is complete.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "rayshade/image/picture.h"
#include "rayshade/render/camera.h"
#include "rayshade/render/pixel_filter.h"
#include "rayshade/render/tile_walk.h"
#include "rayshade/shade/ray_result.h"

namespace rayshade {

class AdaptiveSampling {
 public:
  // camera and picture must outlive this.
  AdaptiveSampling(const Settings& settings, const Camera& camera, bool ahead, Picture* picture);

  // As in PixelSampling.
  std::vector<Sample> Next(size_t most);
  void Put(const Sample& sample, const RayResult& result);
  bool done() const { return done_; }
  int rows_done() const { return done_ ? height_ : row_ - 1; }
  double fraction_done() const;
  std::string Save() const;
  bool Restore(const std::string& bytes);
  uint64_t supersampled_pixels() const { return supersampled_; }
  uint64_t speculative_samples() const { return asked_samples_ - applied_samples_; }

 private:
  struct FullSet {
    std::vector<PixelValue> results;  // by sub-cell
    int missing = 0;
    bool valued = false;
    PixelValue value;
  };
  struct Ask {
    int x = 0, y = 0, sub_cell = 0;  // the next one to hand out
  };
  struct Cross {
    int x[5], y[5];  // left, previous row, right, next row, centre: the order of supersampling
  };
  // Of pixels: sample known, full set applied, full set asked for, full set expected by the guess.
  enum Flag : uint8_t { kSingle = 1, kFull = 2, kAsked = 4, kExpected = 8 };
  struct Range {
    int low = 1 << 30, high = -1;
  };

  size_t index(int x, int y) const { return size_t(y) * width_ + x; }
  const PixelValue& value(int x, int y) const {
    return y < height_ ? picture_->at(x, y) : extra_row_[x];
  }
  PixelValue& value(int x, int y) { return y < height_ ? picture_->at(x, y) : extra_row_[x]; }
  FullSet& set_of(int x, int y) { return sets_[slots_[index(x, y)]]; }
  bool is(int x, int y, Flag flag) const { return flags_[index(x, y)] & flag; }
  static Cross CrossAt(int x, int y) { return {{x - 1, x, x + 1, x, x}, {y, y - 1, y, y + 1, y}}; }

  bool Fires(const Color* const colors[5]) const {
    return settings_.every_pixel_full || ContrastFires(colors, settings_.contrast);
  }

  void AskFull(int x, int y);
  const PixelValue* FullValue(int x, int y);
  void ApplyFull(int x, int y);
  void HandOutFull(size_t most, std::vector<Sample>* samples);
  void HandOutSingles(size_t most, std::vector<Sample>* samples);
  void AskBorder();

  void Replay();
  bool EnterRow(int y);
  bool RefineRow(int y);
  bool FinishLastRow();

  void Unsettle(int x, int y);
  void Guess();
  bool GuessRow(int y, Range range);
  bool GuessFires(int x, int y);
  void LookAhead(size_t most);
  bool LookAheadInRow(int y, uint8_t* full, size_t most);
  int64_t GuessesAllowed() const;

  Settings settings_;
  const Camera& camera_;
  bool ahead_;
  Picture* picture_;
  int width_, height_, cells_;
  std::vector<double> weights_;
  std::vector<PixelValue> extra_row_;  // row height_, sampled but never written
  std::vector<uint8_t> flags_;         // of every pixel, the extra row included
  std::vector<uint32_t> slots_;        // by pixel: its set; valid while asked for and not applied
  std::vector<int> singles_missing_;   // by row
  std::deque<FullSet> sets_;
  std::vector<uint32_t> free_sets_;

  TileWalk walk_;
  TilePixels pixels_;      // of the tile at hand, from the next one on
  int rows_restored_ = 1;  // rows that Restore brought something of
  int border_rows_ = 1;    // rows whose ends were asked for
  bool last_row_asked_ = false;
  std::deque<Ask> asks_;

  bool news_ = false;  // results since the last replay
  int entered_ = 0;    // rows whose singles and ends the replay has taken in
  int row_ = 1;        // being refined
  int x_ = 1;
  bool pass_changed_ = false;
  bool done_ = false;

  std::vector<Range> unsettled_;        // by row: pixels whose test the guess has to look at
  std::vector<int> unsettled_rows_;     // those with a range, in any order
  std::vector<uint64_t> open_;          // by row: samples asked for, of sets not applied
  uint64_t in_vain_ = 0, decided_ = 0;  // of full sets in rows that cannot change any more
  uint64_t samples_handed_ = 0, samples_put_ = 0;
  uint64_t asked_samples_ = 0, applied_samples_ = 0;  // of full sets
  uint64_t supersampled_ = 0;
};

}  // namespace rayshade
