#include "src/deck/curve.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <string_view>

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

// muParser's own message, without its habit of ending lines.
std::invalid_argument make_error(const mu::Parser::exception_type& error) {
  std::string message = error.GetMsg();
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  return std::invalid_argument(message);
}

class ExpressionFunction final : public Curve::Function {
 public:
  explicit ExpressionFunction(const std::string& text) {
    define_names();
    try {
      parser_.SetExpr(text);
      parser_.Eval();
      if (parser_.GetNumResults() != 1)
        throw std::invalid_argument("an expression gives one value; it has several, separated by commas");
      constant_ = parser_.GetUsedVar().empty();
    } catch (const mu::Parser::exception_type& error) {
      throw make_error(error);
    }
  }

  double at(double t) const override {
    const std::lock_guard<std::mutex> lock(mutex_);  // the parser evaluates in place
    time_ = t;
    return parser_.Eval();
  }

  bool is_constant() const override { return constant_; }

 private:
  // Only what docs/deck.md lists, so that an expression means the same with every version of the library.
  void define_names() {
    parser_.ClearFun();
    parser_.ClearConst();
    parser_.DefineVar("t", &time_);
    parser_.DefineConst("pi", std::numbers::pi);
    parser_.DefineConst("e", std::numbers::e);
    using Unary = double (*)(double);
    const std::pair<const char*, Unary> functions[] = {
        {"sin", [](double x) { return std::sin(x); }},
        {"cos", [](double x) { return std::cos(x); }},
        {"tan", [](double x) { return std::tan(x); }},
        {"asin", [](double x) { return std::asin(x); }},
        {"acos", [](double x) { return std::acos(x); }},
        {"atan", [](double x) { return std::atan(x); }},
        {"sinh", [](double x) { return std::sinh(x); }},
        {"cosh", [](double x) { return std::cosh(x); }},
        {"tanh", [](double x) { return std::tanh(x); }},
        {"exp", [](double x) { return std::exp(x); }},
        {"log", [](double x) { return std::log(x); }},
        {"log10", [](double x) { return std::log10(x); }},
        {"sqrt", [](double x) { return std::sqrt(x); }},
        {"abs", [](double x) { return std::abs(x); }},
        {"floor", [](double x) { return std::floor(x); }},
        {"ceil", [](double x) { return std::ceil(x); }},
        {"sign", [](double x) { return x > 0   ? 1.0
                                       : x < 0 ? -1.0
                                               : 0.0; }},
        {"step", [](double x) { return x >= 0 ? 1.0 : 0.0; }}};
    for (const auto& [name, function] : functions) parser_.DefineFun(name, function);
    using Binary = double (*)(double, double);
    parser_.DefineFun("min", static_cast<Binary>([](double x, double y) { return std::min(x, y); }));
    parser_.DefineFun("max", static_cast<Binary>([](double x, double y) { return std::max(x, y); }));
    parser_.DefineFun("atan2", static_cast<Binary>([](double x, double y) { return std::atan2(x, y); }));
  }

  mutable std::mutex mutex_;
  mutable double time_ = 0;
  mu::Parser parser_;
  bool constant_ = false;
};

// A curve is a pure function of t: no assignment, no text, nothing that is not arithmetic.
void check_characters(std::string_view text) {
  constexpr std::size_t longest = 2000;
  if (text.size() > longest) throw std::invalid_argument(fmt::format("it has more than {} characters", longest));
  if (text.find_first_not_of(" \n") == std::string_view::npos) throw std::invalid_argument("it is empty");
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_. \n,+-*/^()<>=!&|?:";
  if (const auto i = text.find_first_not_of(allowed); i != std::string_view::npos) {
    throw std::invalid_argument(fmt::format("unexpected character at position {}", i + 1));
  }
  for (std::size_t i = text.find('='); i != std::string_view::npos; i = text.find('=', i + 1)) {
    const bool compares = (i > 0 && std::string_view("<>!=").find(text[i - 1]) != std::string_view::npos) ||
                          (i + 1 < text.size() && text[i + 1] == '=');
    if (!compares) throw std::invalid_argument(fmt::format("'=' at position {} assigns; '==' compares", i + 1));
  }
}

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

Curve Curve::expression(const std::string& text) {
  check_characters(text);
  return Curve(std::make_shared<ExpressionFunction>(text));
}

double Curve::operator()(double t) const { return function_ ? function_->at(t) : 0.0; }

bool Curve::is_constant() const { return !function_ || function_->is_constant(); }

std::vector<std::pair<double, double>> Curve::rows() const {
  return function_ ? function_->rows() : std::vector<std::pair<double, double>>{};
}

}  // namespace percuss
