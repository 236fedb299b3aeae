#include "flexkey/timeline/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "flexkey/mesh/error.h"
#include "flexkey/timeline/csv.h"
#include "flexkey/timeline/fields.h"
#include "flexkey/timeline/number.h"
#include "flexkey/timeline/overrides.h"
#include "flexkey/timeline/source_text.h"

namespace flexkey {
namespace {

constexpr std::size_t most_runs = 10'000;
constexpr std::string_view example = "{lambda: [0, 0.5, 1]}";

SweepPlan one_run() {
  return {{{}}};
}

/// A value as it stands in the names of outputs: numbers in their shortest form, and of what is no single
/// word its place in the list.
std::string text_of(const Node& value, std::size_t number) {
  if (value.kind != Node::Kind::scalar || value.text.empty()) return fmt::format("{}", number);
  const std::optional<double> as_number = parse_number(value.text);
  return as_number ? number_text(*as_number + 0.0) : value.text;
}

/// The values of one swept key.
std::vector<SweptNode> read_values(const Entry& entry, Findings& findings) {
  const auto& [key, list] = entry;
  if (list.kind != Node::Kind::list || list.items.empty()) {
    findings.error(list.where, "a sweep takes a list of values, such as [0, 0.5, 1]");
    return {};
  }
  std::vector<SweptNode> values;
  for (std::size_t k = 0; k < list.items.size(); ++k) {
    const Node& item = list.items[k];
    SweptNode value{{key.text, text_of(item, k)}, key.where, item};
    const bool is_there = std::any_of(values.begin(), values.end(), [&](const SweptNode& other) {
      return other.named.text == value.named.text;
    });
    if (is_there)
      findings.error(item.where, fmt::format("{} {} is in the sweep twice", key.text, value.named.text));
    else
      values.push_back(std::move(value));
  }
  return values;
}

/// Every combination of the values of all keys.
SweepPlan plan_grid(const Node& sweep, Findings& findings) {
  SweepPlan plan = one_run();
  for (const Entry& entry : sweep.entries) {
    const std::vector<SweptNode> values = read_values(entry, findings);
    if (plan.runs.size() * values.size() > most_runs) {
      findings.error(entry.key.where, fmt::format("the sweep has more than {} runs", most_runs));
      return one_run();
    }
    std::vector<std::vector<SweptNode>> runs;
    for (const std::vector<SweptNode>& run : plan.runs)
      for (const SweptNode& value : values) {
        runs.push_back(run);
        runs.back().push_back(value);
        runs.back().back().named.varies = values.size() > 1;
      }
    if (!runs.empty()) plan.runs = std::move(runs);
  }
  return plan;
}

/// The tree of a cell's text, all of it at the place of the file's name.
Node value_of_cell(const std::string& text, Mark where) {
  Findings findings;
  Node value = marked(parse_yaml(text, findings), where);
  if (findings.has_errors()) throw InputError(findings.errors().front().message);
  return value;
}

std::vector<SweptNode> run_of_row(const CsvRow& row, const std::vector<std::string>& keys, Mark where) {
  if (row.cells.size() != keys.size())
    throw InputError(
        fmt::format("line {}: {} cells, where {} belong", row.line, row.cells.size(), keys.size()));
  std::vector<SweptNode> run;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    try {
      Node value = value_of_cell(row.cells[k], where);
      std::string text = text_of(value, static_cast<std::size_t>(row.line));
      run.push_back({{keys[k], std::move(text)}, where, std::move(value)});
    } catch (const Error& error) {
      throw InputError(fmt::format("line {}: {}", row.line, error.what()));
    }
  }
  return run;
}

SweepPlan plan_of_rows(const std::vector<CsvRow>& rows, Mark where) {
  if (rows.size() < 2) throw InputError("it has no line of values behind the line of keys");
  if (rows.size() > most_runs) throw InputError(fmt::format("it has more than {} runs", most_runs));
  const std::vector<std::string>& keys = rows.front().cells;
  for (const std::string& key : keys)
    if (key.empty() || std::count(keys.begin(), keys.end(), key) > 1)
      throw InputError(key.empty() ? "a column has no key" : fmt::format("two columns are of '{}'", key));
  SweepPlan plan;
  for (std::size_t r = 1; r < rows.size(); ++r) plan.runs.push_back(run_of_row(rows[r], keys, where));
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const auto differs = [&](const std::vector<SweptNode>& run) {
      return run[k].named.text != plan.runs.front()[k].named.text;
    };
    const bool varies = std::any_of(plan.runs.begin(), plan.runs.end(), differs);
    for (std::vector<SweptNode>& run : plan.runs) run[k].named.varies = varies;
  }
  return plan;
}

SweepPlan plan_table(const Node& sweep, const Entry& csv, const Sources& sources, Findings& findings) {
  if (sweep.entries.size() > 1) {
    const Entry& other = &csv == &sweep.entries[0] ? sweep.entries[1] : sweep.entries[0];
    findings.error(other.key.where,
                   fmt::format("'csv' stands alone in a sweep; make '{}' a column of it", other.key.text));
    return one_run();
  }
  if (csv.value.kind != Node::Kind::scalar || csv.value.text.empty()) {
    findings.error(csv.value.where, fmt::format("'csv' is a path, not {}", describe(csv.value)));
    return one_run();
  }
  try {
    const std::string text = sources.text(csv.value.text);
    const std::vector<CsvRow> rows = csv_rows(text);
    SweepPlan plan = plan_of_rows(rows, csv.value.where);
    for (std::size_t r = 1; r < rows.size(); ++r)
      plan.notes.push_back({csv.value.where, fmt::format("line {} of {}", rows[r].line, csv.value.text)});
    return plan;
  } catch (const Error& error) {
    const std::string message = error.what();
    const bool names_file = message.find(csv.value.text) != std::string::npos;
    findings.error(csv.value.where, names_file ? message : fmt::format("{}: {}", csv.value.text, message));
    return one_run();
  }
}

}  // namespace

SweepPlan take_sweep(Node& root, const Sources& sources, Findings& findings) {
  const auto found = std::find_if(root.entries.begin(), root.entries.end(),
                                  [](const Entry& entry) { return entry.key.text == "sweep"; });
  if (found == root.entries.end()) return one_run();
  if (found->value.kind == Node::Kind::null) return one_run();  // which the reader of the rest reports
  const Node sweep = std::move(found->value);
  root.entries.erase(found);
  if (!is_mapping(sweep, "'sweep'", example, findings)) return one_run();
  const Entry* csv = sweep.find("csv");
  return csv != nullptr ? plan_table(sweep, *csv, sources, findings) : plan_grid(sweep, findings);
}

}  // namespace flexkey
