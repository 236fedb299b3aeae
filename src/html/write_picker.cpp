#include "flexkey/html/write_picker.h"

#include <nlohmann/json.hpp>
#include <span>

#include "flexkey/html/base64.h"
#include "flexkey/html/script_text.h"
#include "flexkey/html/viewer.h"
#include "flexkey/mesh/output_file.h"

namespace flexkey {
namespace {

using nlohmann::json;

/// The bytes of numbers as they lie in memory, which is little-endian wherever flexkey is built.
template <class Number>
std::string base64_of(std::span<const Number> numbers) {
  const auto bytes = std::as_bytes(numbers);
  return base64({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

json mesh_json(const Weld& weld, const std::string& name) {
  const Mesh& surface = weld.surface;
  const std::span<const double> positions(surface.positions.data(),
                                          static_cast<std::size_t>(surface.positions.size()));
  return {{"name", name},
          {"positions", base64_of(positions)},
          {"offsets", base64_of(std::span<const int>(surface.face_offsets))},
          {"corners", base64_of(std::span<const int>(surface.corners))},
          {"surface", base64_of(std::span<const int>(weld.to_surface))}};
}

}  // namespace

std::uintmax_t write_picker(const Weld& weld, const std::string& name, const std::filesystem::path& path) {
  constexpr std::string_view place = "@mesh@";
  const std::string_view page = picker_page();
  const std::size_t at = page.find(place);
  OutputFile file(path);
  file.write(page.substr(0, at));
  file.write(script_text(mesh_json(weld, name).dump(-1, ' ', false, json::error_handler_t::replace)));
  file.write(page.substr(at + place.size()));
  file.commit();
  return file.bytes_written();
}

}  // namespace flexkey
