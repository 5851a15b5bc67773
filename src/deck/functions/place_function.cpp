#include "src/deck/functions/place_function.hpp"

#include <mutex>

#include "src/deck/functions/expression.hpp"

namespace percuss {

class PlaceFunction::Function {
 public:
  explicit Function(const std::string& text) {
    define_functions(parser_);
    parser_.DefineVar("x", &place_[0]);
    parser_.DefineVar("y", &place_[1]);
    parser_.DefineVar("z", &place_[2]);
    set_expression(parser_, text);
  }

  double at(const std::array<double, 3>& place) const {
    const std::lock_guard<std::mutex> lock(mutex_);  // the parser evaluates in place
    place_ = place;
    return parser_.Eval();
  }

 private:
  mutable std::mutex mutex_;
  mutable std::array<double, 3> place_{};
  mu::Parser parser_;
};

PlaceFunction PlaceFunction::expression(const std::string& text) {
  PlaceFunction function;
  function.function_ = std::make_shared<const Function>(text);
  return function;
}

double PlaceFunction::operator()(const std::array<double, 3>& at) const { return function_ ? function_->at(at) : 0.0; }

}  // namespace percuss
