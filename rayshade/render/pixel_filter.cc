// See pixel_filter.h.
#include "rayshade/render/pixel_filter.h"

#include <algorithm>
#include <cmath>

#include "rayshade/common/constants.h"

namespace rayshade {

std::vector<double> FilterWeights(const Settings& settings) {
  const int n = settings.samples;
  if (settings.filter == FilterKind::kBox) return std::vector<double>(n * n, 1.0 / (n * n));

  // Gaussian of deviation one pixel, taken at the centres of the sub-cells; summed column by
  // column.
  const double width = settings.filter_width_used(), cell = 1.0 / n;
  std::vector<double> weights(n * n);
  double sum = 0;
  double u = -.5 * width + .5 * width * cell;
  for (int a = 0; a < n; ++a, u += cell * width) {
    double v = -.5 * width + .5 * width * cell;
    for (int b = 0; b < n; ++b, v += cell * width) {
      weights[b * n + a] = std::exp(-.5 * (u * u + v * v));
      sum += weights[b * n + a];
    }
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

bool ContrastFires(const Color* const pixels[5], const Color& threshold) {
  for (int c = 0; c < 3; ++c) {
    double low = (*pixels[0])[c], high = low;
    for (int i = 1; i < 5; ++i) {
      low = std::min(low, (*pixels[i])[c]);
      high = std::max(high, (*pixels[i])[c]);
    }
    if (high + low > kEpsilon && (high - low) / (high + low) > threshold[c]) return true;
  }
  return false;
}

}  // namespace rayshade
