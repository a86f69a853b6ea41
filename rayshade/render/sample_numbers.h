// The order numbers of sub-cells, which spread a pixel's samples over shutter, lens and extended
// lights [rayshade4/1 s.8.5].
#pragma once

namespace rayshade {

// n: 1 to 8; sub_cell: 0 to n*n - 1. For n = 6 to 8 the numbers run from 1 to n*n, as in Rayshade.
int SampleNumber(int n, int sub_cell);

}  // namespace rayshade
