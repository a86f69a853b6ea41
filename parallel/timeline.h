// --timeline FILE: what each trace process did in a run, and when it was busy: figures 7 and 8 of
// the paper are drawn from it. Written by prayshade and prayshade-sim alike. Lines of
//
//   run,SCHEDULE,PROCESSES,TRACE_BEGIN,TRACE_END              seconds since the frame began
//   process,ID,DEMAND_RAYS,DATA_RAYS,FORWARDED_RAYS,BUSY      BUSY: seconds altogether
//   busy,ID,BEGIN,END,BUSY                                    BUSY: seconds between BEGIN and END
#pragma once

#include <string>

#include "parallel/host_process.h"
#include "parallel/run_options.h"

namespace rayshade::parallel {

// Of the last frame. host: phase kDone. Throws std::runtime_error where the file cannot be written.
void WriteTimeline(const std::string& file, const RunOptions& options, const HostProcess& host,
                   double trace_begin_seconds, double trace_end_seconds);

}  // namespace rayshade::parallel
