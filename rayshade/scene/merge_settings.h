// Which of file and command line has the last word [rayshade4/1 s.6].
#pragma once

#include "rayshade/scene/options.h"
#include "rayshade/scene/settings.h"

namespace rayshade {

// What a file finds: defaults, and the options that act before it or toggle with it.
Settings SettingsBeforeFile(const Options& options);

// from_file: what the file left of these.
Settings SettingsAfterFile(const Settings& from_file, const Options& options);

}  // namespace rayshade
