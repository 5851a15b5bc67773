#include "src/deck/functions/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace percuss {
namespace {

/// The parser's own message, without ends of lines.
std::invalid_argument make_parser_error(const mu::Parser::exception_type& error) {
  std::string message = error.GetMsg();
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  return std::invalid_argument(message);
}

/// An expression is a pure function: no assignment, no text, nothing that is not arithmetic.
void check_expression(std::string_view text) {
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

void define_functions(mu::Parser& parser) {
  parser.ClearFun();
  parser.ClearConst();
  parser.DefineConst("pi", std::numbers::pi);
  parser.DefineConst("e", std::numbers::e);
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
  for (const auto& [name, function] : functions) parser.DefineFun(name, function);
  using Binary = double (*)(double, double);
  parser.DefineFun("min", static_cast<Binary>([](double x, double y) { return std::min(x, y); }));
  parser.DefineFun("max", static_cast<Binary>([](double x, double y) { return std::max(x, y); }));
  parser.DefineFun("atan2", static_cast<Binary>([](double x, double y) { return std::atan2(x, y); }));
}

void set_expression(mu::Parser& parser, const std::string& text) {
  check_expression(text);
  try {
    parser.SetExpr(text);
    parser.Eval();
    if (parser.GetNumResults() != 1)
      throw std::invalid_argument("an expression gives one value; it has several, separated by commas");
  } catch (const mu::Parser::exception_type& error) {
    throw make_parser_error(error);
  }
}

}  // namespace percuss
