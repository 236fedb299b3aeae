#include "preview_images/gif_file.h"

#include <stdexcept>
#include <string>

#include "flexkey/mesh/read_file.h"

namespace flexkey::test {
namespace {

/// Reads bytes in their order.
class Reader {
 public:
  explicit Reader(std::string bytes) : bytes_(std::move(bytes)) {}
  int byte() { return static_cast<unsigned char>(bytes_.at(place_++)); }
  int word() {
    const int low = byte();
    return low + 256 * byte();
  }
  std::string text(std::size_t length) {
    place_ += length;
    return bytes_.substr(place_ - length, length);
  }
  std::string blocks() {
    std::string all;
    while (const int length = byte()) all += text(static_cast<std::size_t>(length));
    return all;
  }
  bool ended() const { return place_ == bytes_.size(); }

 private:
  std::string bytes_;
  std::size_t place_ = 0;
};

/// The indices behind LZW codes (GIF89a, appendix F).
std::vector<std::uint8_t> unpack(const std::string& packed, int least_bits) {
  const int clear = 1 << least_bits, end = clear + 1;
  std::vector<std::vector<std::uint8_t>> words;
  std::vector<std::uint8_t> indices, last;
  std::size_t bit = 0;
  const auto reset = [&] {
    words.assign(static_cast<std::size_t>(clear) + 2, {});
    for (int i = 0; i < clear; ++i) words[static_cast<std::size_t>(i)] = {static_cast<std::uint8_t>(i)};
    last.clear();
  };
  reset();
  int bits = least_bits + 1;
  while (true) {
    std::size_t code = 0;
    for (int i = 0; i < bits; ++i, ++bit)
      if (static_cast<unsigned char>(packed.at(bit / 8)) >> bit % 8 & 1) code |= std::size_t{1} << i;
    if (code == static_cast<std::size_t>(end)) return indices;
    if (code == static_cast<std::size_t>(clear)) {
      reset();
      bits = least_bits + 1;
      continue;
    }
    std::vector<std::uint8_t> word = code < words.size() ? words[code] : last;
    if (code >= words.size()) word.push_back(last.at(0));
    if (!last.empty() && words.size() < 4096) {
      last.push_back(word.at(0));
      words.push_back(last);
      if (words.size() == std::size_t{1} << bits && bits < 12) ++bits;
    }
    indices.insert(indices.end(), word.begin(), word.end());
    last = word;
  }
}

struct Control {
  int delay = 0, transparent = -1;
};

GifFile::Frame read_frame(Reader& reader, GifFile& gif, const std::string& palette, const Control& control) {
  GifFile::Frame frame;
  if (!gif.frames.empty()) frame.rgb = gif.frames.back().rgb;
  frame.rgb.resize(static_cast<std::size_t>(gif.width * gif.height * 3));
  frame.left = reader.word();
  frame.top = reader.word();
  frame.width = reader.word();
  frame.height = reader.word();
  frame.delay = control.delay;
  if ((reader.byte() & 0xc0) != 0) throw std::runtime_error("a frame with its own palette, or interlaced");
  const int least_bits = reader.byte();
  const std::vector<std::uint8_t> indices = unpack(reader.blocks(), least_bits);
  if (indices.size() != static_cast<std::size_t>(frame.width * frame.height))
    throw std::runtime_error("a frame with another number of pixels");
  for (int i = 0; i < frame.width * frame.height; ++i) {
    const int index = indices[static_cast<std::size_t>(i)];
    if (index == control.transparent) continue;
    const int x = frame.left + i % frame.width, y = frame.top + i / frame.width;
    for (int c = 0; c < 3; ++c)
      frame.rgb.at(static_cast<std::size_t>((y * gif.width + x) * 3 + c)) =
          static_cast<std::uint8_t>(palette.at(static_cast<std::size_t>(3 * index + c)));
  }
  return frame;
}

void read_extension(Reader& reader, GifFile& gif, Control& control) {
  const int label = reader.byte();
  const std::string data = reader.blocks();
  const auto at = [&](std::size_t i) { return static_cast<int>(static_cast<unsigned char>(data.at(i))); };
  if (label == 0xf9) control = {at(1) + 256 * at(2), (at(0) & 1) != 0 ? at(3) : -1};
  if (label == 0xff && data.starts_with("NETSCAPE2.0")) gif.repeats = at(12) + 256 * at(13);
}

}  // namespace

GifFile read_gif(const std::filesystem::path& path) {
  Reader reader(read_file(path));
  if (reader.text(6) != "GIF89a") throw std::runtime_error("not a GIF");
  GifFile gif;
  gif.width = reader.word();
  gif.height = reader.word();
  const int flags = reader.byte();
  reader.text(2);
  if ((flags & 0x80) == 0) throw std::runtime_error("no global palette");
  const std::string palette = reader.text(std::size_t{3} << ((flags & 7) + 1));
  Control control;
  for (int kind = reader.byte(); kind != 0x3b; kind = reader.byte()) {
    if (kind == 0x21)
      read_extension(reader, gif, control);
    else if (kind == 0x2c)
      gif.frames.push_back(read_frame(reader, gif, palette, control));
    else
      throw std::runtime_error("an unknown block");
  }
  if (!reader.ended()) throw std::runtime_error("bytes after the end");
  return gif;
}

}  // namespace flexkey::test
