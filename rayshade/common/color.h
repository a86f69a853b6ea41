// Red, green and blue, linear and unclamped; arithmetic is channel by channel.
#pragma once

namespace rayshade {

struct Color {
  double r = 0, g = 0, b = 0;

  constexpr double operator[](int channel) const { return channel == 0 ? r : channel == 1 ? g : b; }
  constexpr double& operator[](int channel) { return channel == 0 ? r : channel == 1 ? g : b; }
  constexpr bool operator==(const Color&) const = default;
  constexpr Color& operator+=(const Color& c) {
    r += c.r;
    g += c.g;
    b += c.b;
    return *this;
  }
};

constexpr Color operator+(const Color& a, const Color& b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}
constexpr Color operator*(const Color& a, const Color& b) {
  return {a.r * b.r, a.g * b.g, a.b * b.b};
}
constexpr Color operator*(double s, const Color& a) { return {s * a.r, s * a.g, s * a.b}; }
constexpr Color operator*(const Color& a, double s) { return s * a; }

}  // namespace rayshade
