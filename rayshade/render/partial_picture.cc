// See partial_picture.h. The file: a line of title, the fingerprint, an empty line, the state.
#include "rayshade/render/partial_picture.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "rayshade/image/output_file.h"

namespace rayshade {
namespace {

constexpr char kTitle[] = "rayshade partial picture 1\n";

}  // namespace

std::string PartialFile(const std::string& file) { return file + ".partial"; }

std::string PictureFingerprint(const Settings& s, int frame, uint64_t objects) {
  const Window w = s.window.value_or(Window{0, s.width - 1, 0, s.height - 1});
  char text[800];
  std::snprintf(text, sizeof text,
                "frame %d objects %llu screen %d %d window %d %d %d %d crop %a %a %a %a\n"
                "eye %a %a %a look %a %a %a fov %a %a aperture %a\n"
                "sample %d jitter %d filter %d %a contrast %a %a %a seed %llu\n"
                "depth %d cutoff %a %a %a shadows %d %d\n"
                "pattern %d full %d area cells %d light cutoff %a\n",
                frame, static_cast<unsigned long long>(objects), s.width, s.height, w.xmin, w.xmax,
                w.ymin, w.ymax, s.crop.left, s.crop.right, s.crop.low, s.crop.high, s.eye.x,
                s.eye.y, s.eye.z, s.look.x, s.look.y, s.look.z, s.hfov, s.vfov.value_or(0),
                s.aperture, s.samples, s.jitter, static_cast<int>(s.filter), s.filter_width_used(),
                s.contrast.r, s.contrast.g, s.contrast.b, static_cast<unsigned long long>(s.seed),
                s.max_depth, s.cutoff.r, s.cutoff.g, s.cutoff.b, s.shadows, s.shadow_transparency,
                static_cast<int>(s.pattern), s.every_pixel_full, s.area_cells, s.light_cutoff);
  return text;
}

void WritePartial(const std::string& file, const std::string& fingerprint,
                  const std::string& state) {
  OutputFile output(PartialFile(file));
  for (const std::string& part : {std::string(kTitle), fingerprint, std::string("\n"), state}) {
    std::fwrite(part.data(), 1, part.size(), output.stream());
  }
  output.Commit();
}

std::optional<std::string> ReadPartial(const std::string& file, const std::string& fingerprint) {
  std::ifstream in(PartialFile(file), std::ios::binary);
  if (!in) return std::nullopt;
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::string head = kTitle + fingerprint + "\n";
  if (bytes.compare(0, head.size(), head) != 0) {
    throw std::runtime_error(PartialFile(file) + " is part of another picture.");
  }
  return bytes.substr(head.size());
}

void RemovePartial(const std::string& file) {
  std::error_code ignored;
  std::filesystem::remove(PartialFile(file), ignored);
}

}  // namespace rayshade
