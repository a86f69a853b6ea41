// The operations of the sequential renderer on a spooled scene: what efficiency is measured
// against.
#pragma once

#include "parallel/object_spool.h"
#include "parallel/process.h"

namespace rayshade::parallel {

// Renders the frame that the spool was placed for, and throws the picture away.
WorkDone SequentialWork(ObjectSpool* spool, int frame);

}  // namespace rayshade::parallel
