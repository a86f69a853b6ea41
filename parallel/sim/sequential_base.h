// The operations of the sequential renderer on a spooled scene: what efficiency is measured
// against.
#pragma once

#include "parallel/object_spool.h"
#include "parallel/process.h"
#include "rayshade/image/picture.h"

namespace rayshade::parallel {

// Renders the frame that the spool was placed for. picture: where it is wanted.
WorkDone SequentialWork(ObjectSpool* spool, int frame, Picture* picture = nullptr);

}  // namespace rayshade::parallel
