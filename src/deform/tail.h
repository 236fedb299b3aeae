#pragma once

namespace flexkey {

/// How far a sequence still is from its limit, judged by its steps as by a geometric series.
class GeometricTail {
 public:
  /// After a step of this length: the estimated distance that all further steps cover together; infinite
  /// while nothing can be said (before the third step, or while steps do not shrink).
  double after(double step);

 private:
  int steps_ = 0;
  double step_ = 0;   // the last one
  double ratio_ = 0;  // of the last two
};

}  // namespace flexkey
