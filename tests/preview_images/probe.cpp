// Writes a picture to the path that it is given, as a process of its own in which nothing is loaded yet. Says
// whether OpenImageIO was loaded before and after, or what went wrong.

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/draw.h"
#include "flexkey/preview/images/image_file.h"

namespace {

const char* openimageio() {
  std::ifstream maps("/proc/self/maps");
  const std::string text(std::istreambuf_iterator<char>(maps), {});
  return text.find("libOpenImageIO") == std::string::npos ? "no" : "yes";
}

}  // namespace

int main(int, char** arguments) {
  flexkey::Picture picture = flexkey::blank_picture(8, 8, flexkey::Rgb::Zero());
  flexkey::fill(picture, {2, 2, 4, 4}, {{1, 1, 1}});
  std::printf("before: %s\n", openimageio());
  try {
    flexkey::write_picture(picture, arguments[1]);
  } catch (const flexkey::OutputError& error) {
    std::printf("error: %s\n", error.what());
    return 5;
  }
  std::printf("after: %s\n", openimageio());
}
