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
    try {
      parser_.SetExpr(text);
      parser_.Eval();
      if (parser_.GetNumResults() != 1)
        throw std::invalid_argument("an expression gives one value; it has several, separated by commas");
    } catch (const mu::Parser::exception_type& error) {
      throw make_parser_error(error);
    }
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
  check_expression(text);
  PlaceFunction function;
  function.function_ = std::make_shared<const Function>(text);
  return function;
}

double PlaceFunction::operator()(const std::array<double, 3>& at) const { return function_ ? function_->at(at) : 0.0; }

}  // namespace percuss
