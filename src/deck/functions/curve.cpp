#include "src/deck/functions/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "kernels/node/pulse.hpp"
#include "src/deck/functions/expression.hpp"

namespace percuss {

class Curve::Function {
 public:
  Function() = default;
  Function(const Function&) = delete;
  Function& operator=(const Function&) = delete;
  virtual ~Function() = default;
  virtual double at(double t) const = 0;
  virtual bool is_constant() const { return false; }
  virtual std::vector<std::pair<double, double>> rows() const { return {}; }
  virtual const Pulse* as_pulse() const { return nullptr; }
};

namespace {

class ConstantFunction final : public Curve::Function {
 public:
  explicit ConstantFunction(double value) : value_(value) {}
  double at(double) const override { return value_; }
  bool is_constant() const override { return true; }

 private:
  double value_;
};

class TableFunction final : public Curve::Function {
 public:
  explicit TableFunction(std::vector<std::pair<double, double>> points) : points_(std::move(points)) {}

  double at(double t) const override {
    if (!(t > points_.front().first)) return points_.front().second;
    if (t >= points_.back().first) return points_.back().second;
    const auto after = std::upper_bound(points_.begin(), points_.end(), t,
                                        [](double time, const auto& point) { return time < point.first; });
    const auto& [t1, y1] = *after;
    const auto& [t0, y0] = *(after - 1);
    return std::lerp(y0, y1, (t - t0) / (t1 - t0));
  }

  bool is_constant() const override {
    return std::all_of(points_.begin(), points_.end(),
                       [&](const auto& p) { return p.second == points_.front().second; });
  }

  std::vector<std::pair<double, double>> rows() const override { return points_; }

 private:
  std::vector<std::pair<double, double>> points_;
};

class PulseFunction final : public Curve::Function {
 public:
  explicit PulseFunction(const Pulse& pulse) : pulse_(pulse) {}
  double at(double t) const override { return pulse_(t); }
  const Pulse* as_pulse() const override { return &pulse_; }

 private:
  Pulse pulse_;
};

class ExpressionFunction final : public Curve::Function {
 public:
  explicit ExpressionFunction(const std::string& text) {
    define_functions(parser_);
    parser_.DefineVar("t", &time_);
    set_expression(parser_, text);
    constant_ = parser_.GetUsedVar().empty();
  }

  double at(double t) const override {
    const std::lock_guard<std::mutex> lock(mutex_);  // the parser evaluates in place
    time_ = t;
    return parser_.Eval();
  }

  bool is_constant() const override { return constant_; }

 private:
  mutable std::mutex mutex_;
  mutable double time_ = 0;
  mu::Parser parser_;
  bool constant_ = false;
};

}  // namespace

Curve Curve::constant(double value) { return Curve(std::make_shared<ConstantFunction>(value)); }

Curve Curve::table(std::vector<std::pair<double, double>> points) {
  if (points.empty()) throw std::invalid_argument("the table is empty");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].first) || !std::isfinite(points[i].second)) {
      throw std::invalid_argument(fmt::format("row {} of the table is not finite", i + 1));
    }
    if (i > 0 && !(points[i].first > points[i - 1].first)) {
      throw std::invalid_argument(
          fmt::format("times of the table must ascend; {} follows {}", points[i].first, points[i - 1].first));
    }
  }
  return Curve(std::make_shared<TableFunction>(std::move(points)));
}

Curve Curve::expression(const std::string& text) { return Curve(std::make_shared<ExpressionFunction>(text)); }

Curve Curve::pulse(const Pulse& pulse) { return Curve(std::make_shared<PulseFunction>(pulse)); }

double Curve::operator()(double t) const { return function_ ? function_->at(t) : 0.0; }

bool Curve::is_constant() const { return !function_ || function_->is_constant(); }

std::vector<std::pair<double, double>> Curve::rows() const {
  return function_ ? function_->rows() : std::vector<std::pair<double, double>>{};
}

const Pulse* Curve::as_pulse() const { return function_ ? function_->as_pulse() : nullptr; }

}  // namespace percuss
