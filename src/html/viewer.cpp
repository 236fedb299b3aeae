#include "flexkey/html/viewer.h"

#include <cstddef>

// A file of 700 kB as a literal would take the compiler seconds; the assembler takes it as it is.
asm(".pushsection .rodata\n"
    "flexkey_viewer_begin:\n"
    ".incbin \"" VIEWER_FILE
    "\"\n"
    "flexkey_viewer_end:\n"
    ".popsection\n");

extern "C" const char flexkey_viewer_begin[];
extern "C" const char flexkey_viewer_end[];

namespace flexkey {

std::string_view viewer_page() {
  return {flexkey_viewer_begin, static_cast<std::size_t>(flexkey_viewer_end - flexkey_viewer_begin)};
}

}  // namespace flexkey
