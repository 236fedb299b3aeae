#include "flexkey/html/viewer.h"

#include <cstddef>

// A file of 700 kB as a literal would take the compiler seconds; the assembler takes it as it is.
asm(".pushsection .rodata\n"
    "flexkey_viewer_begin:\n"
    ".incbin \"" VIEWER_FILE
    "\"\n"
    "flexkey_viewer_end:\n"
    "flexkey_picker_begin:\n"
    ".incbin \"" PICKER_FILE
    "\"\n"
    "flexkey_picker_end:\n"
    ".popsection\n");

extern "C" const char flexkey_viewer_begin[], flexkey_viewer_end[];
extern "C" const char flexkey_picker_begin[], flexkey_picker_end[];

namespace flexkey {

std::string_view viewer_page() {
  return {flexkey_viewer_begin, static_cast<std::size_t>(flexkey_viewer_end - flexkey_viewer_begin)};
}

std::string_view picker_page() {
  return {flexkey_picker_begin, static_cast<std::size_t>(flexkey_picker_end - flexkey_picker_begin)};
}

}  // namespace flexkey
