#include <fmt/format.h>

#include <utility>

#include "results.h"
#include "statistics.h"

namespace flexkey::bench {
namespace {

using Show = Cell (*)(double);

/// A figure of both libraries, side by side.
template <class Cost>
struct Duel {
  const char* figure;
  std::vector<Cost> PeerResult::*theirs;
  std::vector<Cost> PeerResult::*ours;
  double Cost::*member;
};

template <class GetCell>
void add_row(Table& table, const std::vector<PeerResult>& peers, std::vector<Cell> names,
             const GetCell& cell) {
  for (const PeerResult& result : peers) names.push_back(cell(result));
  table.rows.push_back(std::move(names));
}

template <class Cost>
void add(Table& table, const std::vector<PeerResult>& peers, const Duel<Cost>& duel, Show show) {
  const auto& [figure, theirs, ours, member] = duel;
  add_row(table, peers, {figure, "CGAL"}, [&](const auto& r) { return show(median_of(r.*theirs, member)); });
  add_row(table, peers, {figure, "flexkey"}, [&](const auto& r) { return show(median_of(r.*ours, member)); });
  add_row(table, peers, {figure, "ratio"},
          [&](const auto& r) { return ratio(median_ratio(r.*theirs, r.*ours, member)); });
}

}  // namespace

Table peer_table(const std::vector<PeerResult>& peers) {
  using R = PeerResult;
  Table table{
      .title = "flexkey (`direct`) and CGAL's Surface_mesh_deformation (ORIGINAL_ARAP) on a bumpy blob",
      .header = {"figure", "of"}};
  for (const PeerResult& result : peers) table.header.push_back(result.size.name);
  add_row(table, peers, {"vertices", ""},
          [](const auto& r) { return Cell(fmt::format("{}", r.vertices), r.vertices); });
  add<StepCost>(table, peers, {"set-up", &R::cgal, &R::plain, &StepCost::set_up}, seconds);
  add<StepCost>(table, peers, {"set-up to predict too", &R::cgal, &R::standard, &StepCost::set_up}, seconds);
  add<StepCost>(table, peers, {"one iteration", &R::cgal, &R::plain, &StepCost::iteration}, seconds);
  add<ClipCost>(table, peers, {"60 frames, 2 iterations", &R::cgal_2, &R::plain_2, &ClipCost::seconds},
                seconds);
  add_row(table, peers, {"60 frames, 2 iterations", "largest difference"},
          [](const auto& r) { return share_of_diagonal(r.difference); });
  add<ClipCost>(table, peers,
                {"60 frames, 5 iterations / to 1e-3", &R::cgal_5, &R::converged, &ClipCost::seconds},
                seconds);
  add_row(table, peers, {"60 frames, to 1e-3", "solves a frame"},
          [](const auto& r) { return count(median_of(r.converged, &ClipCost::solves)); });
  add_row(table, peers, {"60 frames, to 1e-3", "converged"},
          [](const auto& r) { return percent(median_of(r.converged, &ClipCost::converged)); });
  add<StepCost>(table, peers, {"peak memory", &R::cgal, &R::plain, &StepCost::peak}, megabytes);
  add<StepCost>(table, peers, {"peak memory to predict too", &R::cgal, &R::standard, &StepCost::peak},
                megabytes);
  table.note =
      "CPU time of one thread; medians, and medians of the repetitions' ratios. 5 % of the vertices held, 1 "
      "% "
      "bent by 90° and stretched by 30 % in 60 frames. Iterations: λ = 1 from the frame before, as CGAL's; "
      "to "
      "1e-3 of the diagonal: λ = 0.8 and the defaults, while CGAL's 5 iterations do not converge. Memory is "
      "the "
      "whole process's. The answers differ by the weights: CGAL holds each cotangent at 0, flexkey each "
      "edge's "
      "sum.";
  return table;
}

Table thread_table(const ThreadTimes& threads) {
  Table table{.title = fmt::format("One iteration at {} vertices, wall-clock time", threads.vertices),
              .header = {"threads", "time"}};
  table.rows = {{"1", seconds(median(threads.one))}, {"2", seconds(median(threads.two))}};
  return table;
}

Table limit_table(const Limit& limit) {
  Table table{.title = fmt::format("A global solve against memory at {} vertices", limit.vertices),
              .header = {"figure", "value"}};
  table.rows = {{"read bandwidth of one thread, a second", megabytes(limit.bandwidth)},
                {"numbers of the factor", megabytes(limit.factor_bytes)},
                {"to read them twice", seconds(limit.bound())},
                {"one global solve", seconds(limit.solve)},
                {"  ratio", ratio(limit.solve / limit.bound())}};
  return table;
}

}  // namespace flexkey::bench
