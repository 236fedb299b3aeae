#include "flexkey/preview/bayer.h"

namespace flexkey {

int bayer(int x, int y) {
  int order = 0;  // the bits of x ^ y and y, interleaved and reversed
  for (int bit = 0; bit < 3; ++bit) {
    const int across = (x ^ y) >> bit & 1, down = y >> bit & 1;
    order |= (across << 1 | down) << (4 - 2 * bit);
  }
  return order;
}

}  // namespace flexkey
