#include <fmt/format.h>
#include <gif_lib.h>

#include <memory>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/module/codec.h"

namespace flexkey {
namespace {

/// Keeps what giflib writes until the caller takes it: nothing may be thrown through its C code.
int keep(GifFileType* gif, const GifByteType* bytes, int count) {
  const auto written = std::as_bytes(std::span(bytes, static_cast<std::size_t>(count)));
  Bytes& kept = *static_cast<Bytes*>(gif->UserData);
  kept.insert(kept.end(), written.begin(), written.end());
  return count;
}

[[noreturn]] void fail(int error) {
  const char* reason = GifErrorString(error);
  throw OutputError(fmt::format("cannot make a GIF: {}", reason ? reason : "giflib does not say why"));
}

void require(GifFileType* gif, int status) {
  if (status != GIF_OK) fail(gif->Error);
}

struct CloseGif {
  void operator()(GifFileType* gif) const { EGifCloseFile(gif, nullptr); }
};
using Gif = std::unique_ptr<GifFileType, CloseGif>;

void begin(GifFileType* gif, const GifScreen& screen) {
  const std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)> colours(
      GifMakeMapObject(256, reinterpret_cast<const GifColorType*>(screen.palette.data())), GifFreeMapObject);
  if (!colours) fail(E_GIF_ERR_NOT_ENOUGH_MEM);
  EGifSetGifVersion(gif, true);
  require(gif, EGifPutScreenDesc(gif, screen.width, screen.height, 8, 0, colours.get()));
  // The extension of Netscape that repeats the clip for ever.
  const GifByteType forever[3] = {1, 0, 0};
  require(gif, EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE));
  require(gif, EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0"));
  require(gif, EGifPutExtensionBlock(gif, sizeof forever, forever));
  require(gif, EGifPutExtensionTrailer(gif));
}

void put(GifFileType* gif, GifFrame& frame) {
  const GraphicsControlBlock control{DISPOSE_DO_NOT, false, frame.delay, gif_transparent};
  GifByteType block[4];
  EGifGCBToExtension(&control, block);
  require(gif, EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, sizeof block, block));
  require(gif, EGifPutImageDesc(gif, frame.left, frame.top, frame.width, frame.height, false, nullptr));
  for (int row = 0; row < frame.height; ++row)
    require(gif, EGifPutLine(gif, frame.pixels.data() + static_cast<std::ptrdiff_t>(row) * frame.width,
                             frame.width));
}

}  // namespace

void write_gif(const GifScreen& screen, const std::function<bool(GifFrame&)>& next,
               const std::function<void(std::span<const std::byte>)>& sink) {
  Bytes written;
  const auto pass_on = [&] {
    sink(written);
    written.clear();
  };
  int error = 0;
  Gif gif(EGifOpen(&written, keep, &error));
  if (!gif) fail(error);
  begin(gif.get(), screen);
  for (GifFrame frame; next(frame); pass_on()) put(gif.get(), frame);
  if (EGifCloseFile(gif.release(), &error) != GIF_OK) fail(error);
  pass_on();
}

}  // namespace flexkey
