// See message_parts.h.
#include "parallel/message_parts.h"

namespace rayshade::parallel {

void CheckSample(const Sample& s, const Camera& camera, int samples) {
  const PictureWindow& window = camera.window();
  if (s.x < 0 || s.x >= window.width() || s.y < 0 || s.y > window.height() ||
      s.sub_cell >= samples * samples) {
    throw WireError("a sample that the picture does not have");
  }
}

}  // namespace rayshade::parallel
