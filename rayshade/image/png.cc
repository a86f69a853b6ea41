// PNG through libpng; see png.h. Bytes are made as Rayshade 4 made them: gamma, then truncation to
// 255 [rayshade4/1 s.10]. libpng reports errors by longjmp: the functions that call it hold nothing
// that needs a destructor.
#include "rayshade/image/png.h"

#include <fcntl.h>
#include <png.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "rayshade/common/constants.h"
#include "rayshade/image/output_file.h"

namespace rayshade {
namespace {

constexpr uint64_t kPixelsMax = uint64_t{1} << 28;  // of an image that is read

struct ErrorText {
  char text[200] = "";
};

void OnError(png_structp png, png_const_charp text) {
  auto* error = static_cast<ErrorText*>(png_get_error_ptr(png));
  std::snprintf(error->text, sizeof error->text, "%s", text);
  longjmp(png_jmpbuf(png), 1);
}
void OnWarning(png_structp, png_const_charp) {}

uint8_t Quantise(double value) {
  if (value < 0) return 0;
  if (value > 1) return 255;
  return std::isnan(value) ? 0 : static_cast<uint8_t>(value * 255);
}

std::vector<uint8_t> PictureBytes(const Picture& picture, double gamma, AlphaChannel alpha) {
  const double power = std::fabs(gamma) > kEpsilon ? 1 / gamma : kFar;
  const auto byte = [power](double value) {
    return Quantise(power == 1 ? value : std::pow(value, power));
  };
  std::vector<uint8_t> bytes;
  bytes.reserve(size_t(picture.width()) * picture.height() *
                (alpha == AlphaChannel::kNone ? 3 : 4));
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const PixelValue& pixel = picture.at(x, y);
      for (int c = 0; c < 3; ++c) bytes.push_back(byte(pixel.color[c]));
      if (alpha == AlphaChannel::kCoverage) bytes.push_back(Quantise(pixel.alpha));
      if (alpha == AlphaChannel::kSampleMap) bytes.push_back(pixel.full ? 255 : 0);
    }
  }
  return bytes;
}

// Returns false with *error set; true only says that libpng was content (the stream may still fail
// to flush).
bool EncodePng(std::FILE* file, const uint8_t* bytes, int width, int height, int channels,
               ErrorText* error) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, error, OnError, OnWarning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_init_io(png, file);
  png_set_user_limits(png, 0x7fffffff, 0x7fffffff);
  png_set_compression_level(png, 3);
  png_set_IHDR(png, info, width, height, 8,
               channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  for (int y = 0; y < height; ++y) png_write_row(png, bytes + size_t(y) * width * channels);
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return true;
}

struct Decoder {
  std::FILE* file = nullptr;
  png_structp png = nullptr;
  png_infop info = nullptr;
  ErrorText error;
  int width = 0, height = 0, channels = 0;

  ~Decoder() {
    png_destroy_read_struct(&png, &info, nullptr);
    if (file) std::fclose(file);
  }
};

// Header and transformations: afterwards rows are of 1 to 4 channels of 8 bits.
bool DecodeHeader(Decoder* d) {
  d->png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &d->error, OnError, OnWarning);
  d->info = d->png ? png_create_info_struct(d->png) : nullptr;
  if (!d->info || setjmp(png_jmpbuf(d->png))) return false;
  png_init_io(d->png, d->file);
  png_read_info(d->png, d->info);
  png_set_scale_16(d->png);
  png_set_expand(d->png);  // palettes, grey of fewer bits, transparent colours
  png_set_interlace_handling(d->png);
  png_read_update_info(d->png, d->info);
  d->width = png_get_image_width(d->png, d->info);
  d->height = png_get_image_height(d->png, d->info);
  d->channels = png_get_channels(d->png, d->info);
  return true;
}

bool DecodeRows(Decoder* d, uint8_t** rows) {
  if (setjmp(png_jmpbuf(d->png))) return false;
  png_read_image(d->png, rows);
  return true;
}

}  // namespace

void WritePng(const Picture& picture, const std::string& file, double gamma, AlphaChannel alpha) {
  const std::vector<uint8_t> bytes = PictureBytes(picture, gamma, alpha);
  OutputFile output(file);
  ErrorText error;
  errno = 0;
  if (!EncodePng(output.stream(), bytes.data(), picture.width(), picture.height(),
                 alpha == AlphaChannel::kNone ? 3 : 4, &error)) {
    const std::string reason = errno ? std::strerror(errno) : error.text;
    throw std::runtime_error("Cannot write " + file + ": " + reason + ".");
  }
  output.Commit();
}

void CheckWritable(const std::string& file) { OutputFile::Check(file); }

ImageData ReadPng(const std::string& file) {
  Decoder decoder;
  decoder.file = std::fopen(file.c_str(), "rb");
  if (!decoder.file) {
    throw std::runtime_error("Cannot open image file " + file + ": " + std::strerror(errno) + ".");
  }
  const auto fail = [&](const char* reason) -> std::runtime_error {
    return std::runtime_error("Cannot read image file " + file + ": " + reason + ".");
  };
  if (!DecodeHeader(&decoder)) throw fail(decoder.error.text);
  const int width = decoder.width, height = decoder.height, channels = decoder.channels;
  if (uint64_t(width) * height > kPixelsMax) throw fail("too large");

  // Rows, bottom first.
  std::vector<uint8_t> bytes(size_t(width) * height * channels);
  std::vector<uint8_t*> rows(height);
  for (int y = 0; y < height; ++y) {
    rows[y] = bytes.data() + size_t(height - 1 - y) * width * channels;
  }
  if (!DecodeRows(&decoder, rows.data())) throw fail(decoder.error.text);

  // Alpha apart.
  ImageData image;
  image.file = file;
  image.width = width;
  image.height = height;
  image.channels = channels < 3 ? 1 : 3;
  if (image.channels == channels) {
    image.color = std::move(bytes);
    return image;
  }
  image.color.reserve(size_t(width) * height * image.channels);
  image.alpha.reserve(size_t(width) * height);
  for (size_t i = 0; i < bytes.size(); i += channels) {
    image.color.insert(image.color.end(), &bytes[i], &bytes[i] + image.channels);
    image.alpha.push_back(bytes[i + image.channels]);
  }
  return image;
}

}  // namespace rayshade
