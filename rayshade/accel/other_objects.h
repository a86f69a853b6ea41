// Rays against single objects of a set, outside of the kernels: everything that goes through a
// Geom, flat objects where the kernels leave them to this, and the rule about an object's box.
#pragma once

#include <cstdint>
#include <vector>

#include "rayshade/accel/stored_objects.h"
#include "rayshade/accel/trace_view.h"

namespace rayshade {

class OtherObjects {
 public:
  explicit OtherObjects(const StoredObjects* objects) : objects_(objects) {}
  // opaque: by placement, of the surface bound to it; not owned.
  void set_opaque(const std::vector<uint8_t>* opaque, bool all_opaque) {
    opaque_ = opaque;
    all_opaque_ = all_opaque;
  }

  bool bounded(uint32_t object) const;
  void Nearest(const Ray& ray, uint32_t object, double limit, Hit* hit) const;
  Meeting Meets(const Ray& ray, uint32_t object, double limit) const;
  bool MeetsBox(const Ray& ray, uint32_t object, double distance) const;
  void Describe(const Ray& ray, uint32_t object, double distance, HitPath* path) const;

  static TraceCallbacks Callbacks();

 private:
  // The object's hit in the window, in the world. limit: hits of strict kinds lie before it.
  bool Intersect(const Ray& ray, uint32_t object, double limit, double most,
                 double* distance) const;
  bool IntersectOther(const Ray& ray, uint32_t object, double limit, double most,
                      double* distance) const;
  // Is the rule about the object's box to be asked? Flat objects: only where rounding could put the
  // hit outside of it.
  bool BoxDecides(const Ray& ray, uint32_t object, double distance) const;
  // Of a hit on it: is the surface bound to it opaque?
  bool IsOpaque(const Ray& ray, uint32_t object, double distance) const;

  const StoredObjects* objects_;
  const std::vector<uint8_t>* opaque_ = nullptr;
  bool all_opaque_ = false;
};

}  // namespace rayshade
