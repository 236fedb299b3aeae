#include <fmt/format.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/module/codec.h"

// OpenImageIO's own render_text drops the upper bits of two-byte characters: its λ is a semicolon.

namespace flexkey {
namespace {

constexpr std::array fonts{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                           "/usr/share/fonts/TTF/DejaVuSans.ttf",
                           "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf"};  // Debian, Arch, Fedora

struct EndLibrary {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct EndFace {
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};

/// DejaVu Sans.
struct Font {
  std::unique_ptr<FT_LibraryRec_, EndLibrary> library;
  std::unique_ptr<FT_FaceRec_, EndFace> face;
};

Font open_font() {
  Font font;
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  if (FT_Init_FreeType(&library) != 0) throw OutputError("cannot write text in pictures: FreeType fails");
  font.library.reset(library);
  for (const char* path : fonts)
    if (!face && FT_New_Face(library, path, 0, &face) != 0) face = nullptr;
  if (!face)
    throw OutputError(
        "cannot write text in pictures: no font DejaVuSans.ttf; install the package fonts-dejavu-core");
  font.face.reset(face);
  return font;
}

/// The code points of a UTF-8 text.
std::u32string code_points(const std::string& text) {
  std::u32string points;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const int lead = byte < 0x80 ? 0x7f : byte >= 0xf0 ? 0x07 : byte >= 0xe0 ? 0x0f : 0x1f;
    if (byte >= 0x80 && byte < 0xc0 && !points.empty())
      points.back() = points.back() << 6 | (byte & 0x3f);
    else
      points.push_back(static_cast<char32_t>(byte & lead));
  }
  return points;
}

/// A coverage that holds both the old one and a glyph's box.
Coverage widened(const Coverage& old, const Coverage& glyph) {
  if (glyph.share.empty()) return old;
  const bool first = old.share.empty();
  const int left = first ? glyph.left : std::min(old.left, glyph.left);
  const int top = first ? glyph.top : std::min(old.top, glyph.top);
  const int right = std::max(first ? left : old.left + old.width, glyph.left + glyph.width);
  const int bottom = std::max(first ? top : old.top + old.height, glyph.top + glyph.height);
  Coverage wide{right - left, bottom - top, left, top, {}};
  wide.share.resize(static_cast<std::size_t>(wide.width) * static_cast<std::size_t>(wide.height));
  for (const Coverage* part : {&old, &glyph})
    for (int y = 0; y < part->height; ++y)
      for (int x = 0; x < part->width; ++x) {
        float& share =
            wide.share[static_cast<std::size_t>((part->top - top + y) * wide.width + part->left - left + x)];
        share = std::max(share, part->share[static_cast<std::size_t>(y * part->width + x)]);
      }
  return wide;
}

/// The glyph that FreeType has drawn last, with the pen at (pen, 0).
Coverage drawn_glyph(const FT_GlyphSlot slot, int pen) {
  const FT_Bitmap& bitmap = slot->bitmap;
  Coverage glyph{static_cast<int>(bitmap.width),
                 static_cast<int>(bitmap.rows),
                 pen + slot->bitmap_left,
                 -slot->bitmap_top,
                 {}};
  for (int y = 0; y < glyph.height; ++y)
    for (int x = 0; x < glyph.width; ++x)
      glyph.share.push_back(static_cast<float>(bitmap.buffer[y * bitmap.pitch + x]) / 255);
  return glyph;
}

}  // namespace

Coverage text_coverage(const std::string& text, int size) {
  const Font font =
      open_font();  // each time: a face serves one thread, and opening it takes a tenth of a millisecond
  FT_Face face = font.face.get();
  Coverage line;
  int pen = 0;
  if (FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(std::max(1, size))) != 0) return line;
  for (const char32_t point : code_points(text)) {
    // Fitted to the pixels' rows alone, which keeps small digits crisp and their shapes true.
    if (FT_Load_Char(face, point, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) != 0) continue;
    line = widened(line, drawn_glyph(face->glyph, pen));
    pen += static_cast<int>(std::lround(static_cast<double>(face->glyph->advance.x) / 64));
  }
  return line;
}

}  // namespace flexkey
