#include <webp/mux.h>

#include <memory>

#include "flexkey/mesh/error.h"
#include "flexkey/preview/images/module/codec.h"

namespace flexkey {
namespace {

// An XMP packet around a Dublin Core description, which needs no escapes: it holds letters, digits, =, . and
// -.
constexpr std::string_view before =
    R"(<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">)"
    R"(<rdf:Description rdf:about="" xmlns:dc="http://purl.org/dc/elements/1.1/"><dc:description><rdf:Alt>)"
    R"(<rdf:li xml:lang="x-default">)";
constexpr std::string_view after =
    "</rdf:li></rdf:Alt></dc:description></rdf:Description></rdf:RDF></x:xmpmeta>";

struct DeleteMux {
  void operator()(WebPMux* mux) const { WebPMuxDelete(mux); }
};
using Mux = std::unique_ptr<WebPMux, DeleteMux>;

WebPData data_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

}  // namespace

Bytes with_description(const Bytes& webp, const std::string& description) {
  std::string packet(before);
  packet.append(description).append(after);
  const WebPData image = data_of(webp), xmp = data_of(std::as_bytes(std::span(packet)));
  const Mux mux(WebPMuxCreate(&image, 0));
  WebPData whole{};
  if (!mux || WebPMuxSetChunk(mux.get(), "XMP ", &xmp, 0) != WEBP_MUX_OK ||
      WebPMuxAssemble(mux.get(), &whole) != WEBP_MUX_OK)
    throw OutputError("cannot make a webp picture: its description cannot be added");
  const auto bytes = std::as_bytes(std::span(whole.bytes, whole.size));
  const Bytes result(bytes.begin(), bytes.end());
  WebPDataClear(&whole);
  return result;
}

std::string description_of(const Bytes& webp) {
  const WebPData image = data_of(webp);
  const Mux mux(WebPMuxCreate(&image, 0));
  WebPData xmp{};
  if (!mux || WebPMuxGetChunk(mux.get(), "XMP ", &xmp) != WEBP_MUX_OK) return {};
  const std::string_view packet(reinterpret_cast<const char*>(xmp.bytes), xmp.size);
  if (!packet.starts_with(before) || !packet.ends_with(after) || packet.size() < before.size() + after.size())
    return {};
  return std::string(packet.substr(before.size(), packet.size() - before.size() - after.size()));
}

}  // namespace flexkey
