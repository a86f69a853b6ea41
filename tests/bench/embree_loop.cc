// A yardstick for `make bench`: the same primary, shadow and mirror rays as the renderer's, traced
// by single-ray calls of Embree 3 in single precision. It reads the spheres and polygons of a scene
// written without transformations, macros or expressions (sphereflake --paper, the rooms after
// cpp), the view and the point lights, and ignores the rest.
//
//   embree_loop SCENE PIXELS   prints the seconds of tracing
#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Vec {
  float x = 0, y = 0, z = 0;
};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(float s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
float Dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec Cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec Unit(Vec a) { return 1 / std::sqrt(Dot(a, a)) * a; }

struct SceneFile {
  std::vector<float> spheres;    // x y z r
  std::vector<uint8_t> mirrors;  // by sphere
  std::vector<float> vertices;
  std::vector<unsigned> triangles;  // fans of the polygons
  std::vector<Vec> lights;
  Vec eye, look;
  float fov = 45;
  int depth = 5;
};

// The numbers of the rest of a line; a surface's name in front of them goes to *surface.
std::vector<float> Numbers(std::istringstream& in, std::string* surface) {
  std::vector<float> numbers;
  for (std::string word; in >> word;) {
    char* end;
    const float number = std::strtof(word.c_str(), &end);
    if (*end == '\0') {
      numbers.push_back(number);
    } else if (numbers.empty()) {
      *surface = word;
    }
  }
  return numbers;
}

SceneFile Read(const char* name) {
  SceneFile scene;
  std::ifstream file(name);
  std::string line, word, current;
  while (std::getline(file, line)) {
    std::istringstream in(line);
    if (!(in >> word)) continue;
    std::string surface = current;
    if (word == "applysurf") {
      in >> current;
    } else if (word == "sphere") {
      const std::vector<float> n = Numbers(in, &surface);
      if (n.size() < 4) continue;
      scene.spheres.insert(scene.spheres.end(), {n[1], n[2], n[3], n[0]});
      scene.mirrors.push_back(surface == "shiny");
    } else if (word == "poly" || word == "polygon") {
      const std::vector<float> n = Numbers(in, &surface);
      const unsigned first = static_cast<unsigned>(scene.vertices.size() / 3);
      scene.vertices.insert(scene.vertices.end(), n.begin(), n.end());
      const unsigned end = static_cast<unsigned>(scene.vertices.size() / 3);
      for (unsigned i = first + 1; i + 1 < end; ++i) {
        scene.triangles.insert(scene.triangles.end(), {first, i, i + 1});
      }
    } else if (word == "light") {
      float intensity;
      Vec p;
      if (in >> intensity >> word >> p.x >> p.y >> p.z && word == "point")
        scene.lights.push_back(p);
    } else if (word == "eyep") {
      in >> scene.eye.x >> scene.eye.y >> scene.eye.z;
    } else if (word == "lookp") {
      in >> scene.look.x >> scene.look.y >> scene.look.z;
    } else if (word == "fov") {
      in >> scene.fov;
    } else if (word == "maxdepth") {
      in >> scene.depth;
    }
  }
  return scene;
}

class Tracer {
 public:
  explicit Tracer(const SceneFile& scene)
      : file_(scene), device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    if (!scene.spheres.empty())
      spheres_ = Attach(RTC_GEOMETRY_TYPE_SPHERE_POINT, RTC_FORMAT_FLOAT4, scene.spheres, 4);
    if (!scene.triangles.empty())
      Attach(RTC_GEOMETRY_TYPE_TRIANGLE, RTC_FORMAT_FLOAT3, scene.vertices, 3);
    rtcCommitScene(scene_);
  }

  double Trace(int pixels) {
    const auto begin = std::chrono::steady_clock::now();
    const Vec ahead = Unit(file_.look - file_.eye), right = Unit(Cross(ahead, {0, 0, 1}));
    const Vec up = Cross(right, ahead);
    const float half = std::tan(file_.fov * static_cast<float>(M_PI) / 360);
    for (int y = 0; y < pixels; ++y) {
      for (int x = 0; x < pixels; ++x) {
        const float px = (2 * (x + .5f) / pixels - 1) * half,
                    py = (1 - 2 * (y + .5f) / pixels) * half;
        Follow(file_.eye, Unit(ahead + px * right + py * up));
      }
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

 private:
  unsigned Attach(RTCGeometryType type, RTCFormat format, const std::vector<float>& data,
                  unsigned stride) {
    RTCGeometry geometry = rtcNewGeometry(device_, type);
    auto* to = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, format, stride * sizeof(float), data.size() / stride));
    std::copy(data.begin(), data.end(), to);
    if (type == RTC_GEOMETRY_TYPE_TRIANGLE) {
      auto* index = static_cast<unsigned*>(
          rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                  3 * sizeof(unsigned), file_.triangles.size() / 3));
      std::copy(file_.triangles.begin(), file_.triangles.end(), index);
    }
    rtcCommitGeometry(geometry);
    return rtcAttachGeometry(scene_, geometry);
  }

  void Follow(Vec origin, Vec direction) {
    for (int depth = 0; depth <= file_.depth; ++depth) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      RTCRayHit ray;
      ray.ray = {origin.x,    origin.y,    origin.z,    depth > 0 ? 1e-4f : 0,
                 direction.x, direction.y, direction.z, 0,
                 1e30f,       ~0u,         0,           0};
      ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene_, &context, &ray);
      if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
      const Vec point = origin + ray.ray.tfar * direction;
      Vec normal = Unit({ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z});
      if (Dot(normal, direction) > 0) normal = -1 * normal;
      for (const Vec& light : file_.lights) Shadow(point, normal, light);
      if (ray.hit.geomID != spheres_ || !file_.mirrors[ray.hit.primID]) return;
      origin = point;
      direction = direction - 2 * Dot(direction, normal) * normal;
    }
  }

  void Shadow(Vec point, Vec normal, Vec light) {
    const Vec toward = light - point;
    if (Dot(toward, normal) <= 0) return;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray = {point.x,  point.y, point.z, 1e-4f, toward.x, toward.y,
                  toward.z, 0,       0.9999f, ~0u,   0,        0};
    rtcOccluded1(scene_, &context, &ray);
    blocked_ += ray.tfar < 0;
  }

  const SceneFile& file_;
  RTCDevice device_;
  RTCScene scene_;
  unsigned spheres_ = RTC_INVALID_GEOMETRY_ID;
  long blocked_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: embree_loop SCENE PIXELS\n");
    return 2;
  }
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  const SceneFile scene = Read(argv[1]);
  Tracer tracer(scene);
  std::printf("%.4f\n", tracer.Trace(std::atoi(argv[2])));
}
