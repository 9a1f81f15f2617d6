#pragma once

#include <cmath>
#include <cstddef>
#include <string>

namespace lapidary::test {

/// Mean and variance of a stream of numbers. Source: Welford 1962.
class RunningMean {
 public:
  void add(double x) {
    ++count_;
    const double delta = x - mean_;
    mean_ += delta / static_cast<double>(count_);
    squares_ += delta * (x - mean_);
  }

  /// Of the same numbers with `x` added to each.
  RunningMean shifted(double x) const {
    RunningMean result = *this;
    result.mean_ += x;
    return result;
  }

  std::size_t count() const { return count_; }
  double mean() const { return mean_; }
  /// Of one number, unbiased; 0 for fewer than two numbers.
  double variance() const { return count_ < 2 ? 0.0 : squares_ / static_cast<double>(count_ - 1); }
  /// Of the mean, if the numbers are independent.
  double standard_error() const {
    return count_ == 0 ? 0.0 : std::sqrt(variance() / static_cast<double>(count_));
  }

 private:
  std::size_t count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;
};

/// Whether a measured mean agrees with a known one.
struct ZTestResult {
  bool accepted = false;
  double z = 0.0;       ///< deviation in standard errors
  std::string message;  ///< both values and the deviation
};

/// Accepts when the mean lies within `k` standard errors, plus `tolerance` for what `expected`
/// itself may be wrong by. A correct mean is refused with probability `z_false_alarm(k)`: 0.0027
/// for k = 3, 6.3e-5 for k = 4, 5.7e-7 for k = 5.
ZTestResult z_test(const RunningMean& measured, double expected, double k, double tolerance = 0.0);

/// P(|Z| > k) of a standard normal variable Z.
inline double z_false_alarm(double k) {
  return std::erfc(k / std::sqrt(2.0));
}

}  // namespace lapidary::test
