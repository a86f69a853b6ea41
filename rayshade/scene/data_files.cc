// Readers of data files [rayshade4/2 s.6.12, rayshade4/3 s.9.3, 11.4]; see data_files.h.
#include "rayshade/scene/data_files.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "rayshade/image/png.h"

namespace rayshade {
namespace {

constexpr uint64_t kMostImageBytes = uint64_t{1} << 32;

std::ifstream Open(const std::string& path, const std::string& complaint) {
  std::error_code ignored;
  std::ifstream file;
  if (std::filesystem::is_regular_file(path, ignored)) file.open(path, std::ios::binary);
  if (!file.is_open()) throw DataFileError(Severity::kError, complaint);
  return file;
}

// Bytes from here to the end.
uint64_t BytesLeft(std::ifstream* file) {
  const auto here = file->tellg();
  file->seekg(0, std::ios::end);
  const auto end = file->tellg();
  file->seekg(here);
  return here < 0 || end < here ? 0 : static_cast<uint64_t>(end - here);
}

bool IsPng(std::ifstream* file) {
  char signature[8] = {};
  file->read(signature, 8);
  const bool png = file->gcount() == 8 && std::memcmp(signature, "\x89PNG\r\n\x1a\n", 8) == 0;
  file->clear();
  file->seekg(0);
  return png;
}

// Of the Utah Raster Toolkit, whose pictures old scenes name; no library that is kept up reads
// them.
bool IsUtahRle(std::ifstream* file) {
  const bool rle = file->get() == 0x52 && file->get() == 0xcc;
  file->clear();
  file->seekg(0);
  return rle;
}

ImageData Png(const std::string& path, const std::string& name) {
  try {
    return ReadPng(path);
  } catch (const std::runtime_error& error) {
    throw DataFileError(Severity::kError, "Cannot read image file " + name + ": " + error.what());
  }
}

ColorMap ParseColorMap(std::ifstream* file, const std::string& name) {
  ColorMap map(256);
  std::string line;
  for (int i = 0; i < 256 && std::getline(*file, line); ++i) {
    std::istringstream numbers(line);
    long r = 0, g = 0, b = 0;
    if (!(numbers >> r >> g >> b)) {
      throw DataFileError(Severity::kFatal, "Line " + std::to_string(i + 1) +
                                                " of colormap file \"" + name +
                                                "\" has no three integers.");
    }
    map[i] = (1.0 / 255.0) * Color{double(r), double(g), double(b)};
  }
  return map;
}

std::shared_ptr<const std::vector<float>> PngAltitudes(const ImageData& image, int* size) {
  if (image.width != image.height || image.width < 2) {
    throw DataFileError(Severity::kError, "Height field image " + image.file + " is not square.");
  }
  *size = image.width;
  auto altitudes = std::make_shared<std::vector<float>>();
  for (size_t i = 0; i < size_t(image.width) * image.height; ++i) {
    altitudes->push_back(static_cast<float>(image.color[i * image.channels] / 255.0));
  }
  return altitudes;
}

std::shared_ptr<const std::vector<float>> BinaryAltitudes(std::ifstream* file, int* size) {
  int32_t n = 0;
  if (!file->read(reinterpret_cast<char*>(&n), sizeof n)) {
    throw DataFileError(Severity::kError, "Cannot read height field size.");
  }
  if (n < 2) throw DataFileError(Severity::kError, "Invalid height field size.");
  const uint64_t count = static_cast<uint64_t>(n) * n;
  if (BytesLeft(file) / sizeof(float) < count) {
    throw DataFileError(Severity::kError, "Not enough heightfield data.");
  }
  auto altitudes = std::make_shared<std::vector<float>>(count);
  file->read(reinterpret_cast<char*>(altitudes->data()),
             static_cast<std::streamsize>(count * sizeof(float)));
  if (!*file) throw DataFileError(Severity::kError, "Not enough heightfield data.");
  *size = n;
  return altitudes;
}

ImageData GenericImage(std::ifstream* file, const std::string& name) {
  const DataFileError bad(Severity::kError, "Image file " + name + " is not of a known format.");
  ImageData image;
  std::string line;
  std::getline(*file, line);
  std::istringstream header(line);
  if (!(header >> image.width >> image.height) || image.width < 1 || image.height < 1) throw bad;
  const uint64_t bytes = static_cast<uint64_t>(image.width) * image.height * 3;
  if (bytes > kMostImageBytes || BytesLeft(file) < bytes) throw bad;
  image.channels = 3;
  image.color.resize(bytes);
  file->read(reinterpret_cast<char*>(image.color.data()), static_cast<std::streamsize>(bytes));
  if (!*file) throw bad;
  return image;
}

}  // namespace

DataFiles::DataFiles(const std::string& scene_file) {
  const size_t slash = scene_file.rfind('/');
  if (slash != std::string::npos) folder_ = scene_file.substr(0, slash + 1);
}

std::string DataFiles::Find(const std::string& name) const {
  std::error_code ignored;
  if (folder_.empty() || name.starts_with('/') || std::filesystem::exists(name, ignored) ||
      !std::filesystem::exists(folder_ + name, ignored)) {
    return name;
  }
  return folder_ + name;
}

std::shared_ptr<const ColorMap> DataFiles::ReadColorMap(const std::string& name) {
  std::shared_ptr<const ColorMap>& map = maps_[name];
  if (!map) {
    std::ifstream file = Open(Find(name), "Cannot open colormap file \"" + name + "\".");
    map = std::make_shared<ColorMap>(ParseColorMap(&file, name));
  }
  return map;
}

HeightfieldSpec DataFiles::ReadHeightfield(const std::string& name) {
  HeightfieldSpec& spec = heightfields_[name];
  if (!spec.altitudes) {
    const std::string path = Find(name);
    std::ifstream file = Open(path, "Cannot open heightfield file \"" + name + "\".");
    spec.file = name;
    spec.altitudes = IsPng(&file) ? PngAltitudes(Png(path, name), &spec.size)
                                  : BinaryAltitudes(&file, &spec.size);
  }
  return spec;
}

std::shared_ptr<const ImageData> DataFiles::ReadImage(const std::string& name) {
  std::shared_ptr<const ImageData>& image = images_[name];
  if (!image) {
    const std::string path = Find(name);
    std::ifstream file = Open(path, "Cannot open image file " + name + ".");
    if (IsUtahRle(&file)) {
      throw DataFileError(Severity::kError,
                          "Image file " + name +
                              " is Utah RLE, which is not read. Make a PNG of it: "
                              "rletopnm " +
                              name + " | pnmtopng > " + name + ".png");
    }
    ImageData data = IsPng(&file) ? Png(path, name) : GenericImage(&file, name);
    data.file = name;
    image = std::make_shared<ImageData>(std::move(data));
  }
  return image;
}

}  // namespace rayshade
