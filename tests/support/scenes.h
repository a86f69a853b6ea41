// Scenes for tests of the parallel layer, as text in the scene language.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rayshade::parallel {

// Haines' balls of a size with the paper's view, `pixels` x `pixels`, one sample per pixel [RJ
// s.5].
std::string Balls(int size, int pixels);
// The project's conference room with 8 lights (scenes/room8.ray), its includes put in.
std::string Room(int pixels);
// Two mirrors facing each other, a coloured ball between them, cut by a voxel border.
std::string FacingMirrors();
// Transparent and opaque balls and panes, with coloured shadows and total reflection.
std::string GlassScene();
// One named object placed many times.
std::string InstanceScene();
// Scenes made to hurt, with their names.
std::vector<std::pair<std::string, std::string>> HardScenes();

}  // namespace rayshade::parallel
