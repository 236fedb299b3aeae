// libFuzzer's side: fuzz --target=NAME, and then what libFuzzer takes.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/targets.h"

namespace {
const flexkey::fuzz::Target* target = nullptr;
}

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  constexpr std::string_view flag = "--target=";
  for (int k = 1; k < *count; ++k) {
    const std::string_view argument = (*arguments)[k];
    if (argument.starts_with(flag)) target = flexkey::fuzz::find_target(argument.substr(flag.size()));
  }
  if (target == nullptr) {
    std::fputs("usage: fuzz --target=NAME [libFuzzer's flags] [FOLDERS]\n", stderr);
    std::exit(2);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  target->run({reinterpret_cast<const char*>(bytes), size});
  return 0;
}
