#include "cli/yaml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>

namespace flexkey::cli {

std::string quoted(const std::string& text) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '.' || c == '/';
  };
  const bool is_word = !text.empty() && text != "null" &&
                       std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
                       std::all_of(text.begin(), text.end(), is_plain);
  const bool is_path = text.starts_with("../") || text.starts_with("/");
  if (is_word || (is_path && std::all_of(text.begin(), text.end(), is_plain))) return text;
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

double rounded(double value, double size) {
  const double step = std::pow(10, std::floor(std::log10(size)) - 4);
  return std::round(value / step) * step;
}

Vec3 rounded(const Vec3& point, double size) {
  return {rounded(point[0], size), rounded(point[1], size), rounded(point[2], size)};
}

std::string yaml_of(const Vec3& point) {
  const auto number = [](double value) { return value == 0 ? 0.0 : value; };  // no "-0"
  return fmt::format("[{:.15g}, {:.15g}, {:.15g}]", number(point[0]), number(point[1]), number(point[2]));
}

}  // namespace flexkey::cli
