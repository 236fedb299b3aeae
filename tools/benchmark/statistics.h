#pragma once

#include <algorithm>
#include <vector>

namespace flexkey::bench {

/// The middle one, or the mean of the two in the middle; values is not empty.
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// The median of a figure over repetitions.
template <class Cost>
double median_of(const std::vector<Cost>& costs, double Cost::*figure) {
  std::vector<double> values;
  for (const Cost& cost : costs) values.push_back(cost.*figure);
  return median(values);
}

/// The median of the repetitions' own ratios a / b: what both sides met in one round is compared.
template <class Cost>
double median_ratio(const std::vector<Cost>& a, const std::vector<Cost>& b, double Cost::*figure) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < a.size(); ++k) ratios.push_back(a[k].*figure / (b[k].*figure));
  return median(ratios);
}

}  // namespace flexkey::bench
