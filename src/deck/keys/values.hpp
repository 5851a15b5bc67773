#pragma once
// Readers of single values. Each has
//   bool read(reader, name, node, out) const   false after telling what is wrong; out is then unchanged
//   std::string takes() const                  what the value is, for messages and docs/deck.md
//   Form form() const                          the same as data, for the list of keys and the schema
// `name` is what messages call the value ("time.end", "initial.0.velocity"). A reader is named in one place for each
// key: the tables in *_keys.cpp.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/deck/keys/form.hpp"
#include "src/deck/keys/reader.hpp"
#include "src/deck/text/nearest_name.hpp"

namespace percuss {

struct NumberValue {
  Range range = any_number;
  bool read(const Reader& reader, const std::string& name, const Node& node, double& out) const;
  std::string takes() const { return range.text.empty() ? "a number" : "a number, " + range.text; }
  Form form() const { return number_form(range); }
};

struct IntegerValue {
  long low = 1, high = std::numeric_limits<int>::max();
  bool read(const Reader& reader, const std::string& name, const Node& node, long& out) const;
  bool read(const Reader& reader, const std::string& name, const Node& node, int& out) const;
  std::string takes() const { return fmt::format("an integer, at least {}", low); }
  Form form() const;
};

struct BooleanValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, bool& out) const;
  std::string takes() const { return "true or false"; }
  Form form() const { return {Form::Kind::boolean}; }
};

/// Any text, numbers included.
struct TextValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const;
  std::string takes() const { return "a text"; }
  Form form() const { return {Form::Kind::text}; }
};

/// A name that the user gives: letters, digits, '_' and '-', beginning with a letter or '_'.
struct NameValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const;
  std::string takes() const { return "a name"; }
  Form form() const { return {Form::Kind::text}; }
};
bool is_name(const std::string& text);

/// One of a few words.
template <class E>
struct ChoiceValue {
  std::vector<std::pair<std::string, E>> choices;

  std::vector<std::string> words() const {
    std::vector<std::string> all;
    for (const auto& choice : choices) all.push_back(choice.first);
    return all;
  }

  bool read(const Reader& reader, const std::string& name, const Node& node, E& out) const {
    if (node.kind == Node::Kind::scalar) {
      for (const auto& [word, value] : choices) {
        if (node.text == word) {
          out = value;
          return true;
        }
      }
    }
    const std::string near = node.kind == Node::Kind::scalar ? nearest_name(node.text, words()) : "";
    reader.refuse(node, name, takes() + (near.empty() ? "" : "; did you mean '" + near + "'?"));
    return false;
  }

  std::string takes() const { return fmt::format("{}", fmt::join(words(), " | ")); }
  Form form() const { return word_form(words()); }
};

/// Hint for a list that is longer than it must be because decimal commas have cut its numbers; or nothing.
std::string comma_hint(const Node& list, std::size_t wanted);

/// Exactly N values of one kind, [x, y, z].
template <class Item, std::size_t N>
struct TupleValue {
  Item item;

  template <class T>
  bool read(const Reader& reader, const std::string& name, const Node& node, std::array<T, N>& out) const {
    if (node.kind != Node::Kind::list || node.items.size() != N) {
      reader.refuse(node, name, takes() + comma_hint(node, N));
      return false;
    }
    std::array<T, N> values{};
    bool good = true;
    for (std::size_t i = 0; i < N; ++i)
      good = item.read(reader, fmt::format("{}.{}", name, i), node.items[i], values[i]) && good;
    if (good) out = values;
    return good;
  }

  std::string takes() const { return fmt::format("a list of {}, each {}", N, item.takes()); }
  Form form() const { return tuple_form(std::vector<Form>(N, item.form())); }
};

inline TupleValue<NumberValue, 3> vector3(Range range = any_number) { return {{std::move(range)}}; }

/// A list of values of one kind; `reader` gets the number of the item.
template <class Item>
struct ListValue {
  Item item;

  template <class T>
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<T>& out) const {
    if (!reader.expect(node, Node::Kind::list, name, takes())) return false;
    bool good = true;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      T value{};
      const bool read_it = item.read(reader, fmt::format("{}.{}", name, i), node.items[i], value);
      if (read_it) out.push_back(std::move(value));
      good = good && read_it;
    }
    return good;
  }

  std::string takes() const { return "a list, each " + item.takes(); }
  Form form() const { return list_form(item.form()); }
};

/// x, y, z, -x, -y, -z or a vector that is not zero; read as a unit vector.
struct DirectionValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, Vec3& out) const;
  std::string takes() const { return "x | y | z | -x | -y | -z or a vector that is not zero"; }
  Form form() const { return any_form({word_form({"x", "y", "z", "-x", "-y", "-z"}), vector3().form()}); }
};

/// A number, {table: [[t, value], ...]} or {expression: "..."}.
struct CurveValue {
  bool is_not_negative = false;  // whether its values must be zero or positive
  bool read(const Reader& reader, const std::string& name, const Node& node, Curve& out) const;
  std::string takes() const { return is_not_negative ? "a curve, zero or positive" : "a curve"; }
  Form form() const;
};

/// An expression of the place.
struct PlaceFunctionValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, PlaceFunction& out) const;
  std::string takes() const { return "a text, an expression of x, y and z"; }
  Form form() const { return any_form({TextValue{}.form(), number_form()}); }
};

/// A part by name; all (or an empty result) for the whole mesh.
struct PartNameValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const;
  std::string takes() const { return "a name from parts, or all"; }
  Form form() const { return {Form::Kind::text}; }
};

/// "part", "part/side", "all" or {name: ..., inside: [[x, y, z], [x, y, z]]}.
struct SelectorValue {
  Chosen chosen = Chosen::some;
  bool read(const Reader& reader, const std::string& name, const Node& node, Selector& out) const;
  std::string takes() const { return "a selector"; }
  Form form() const;
};

}  // namespace percuss
