// parse_yaml: from yaml-cpp's events to the tree. yaml-cpp's own nodes are not used, because they resolve aliases,
// keep the last of duplicate keys and know the place of values but not of keys.

#include <fmt/format.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/yaml.h>  // whole: its parts declare a Node, which clang-tidy misses otherwise

#include <sstream>
#include <unordered_map>

#include "src/deck/text/deck_text.hpp"
#include "src/deck/yaml/yaml_tree.hpp"

namespace percuss {
namespace {

constexpr std::size_t deepest = 32;
constexpr std::size_t most_values = 1'000'000;

// Ends the parse after an error that makes what follows meaningless; the error is reported already.
struct GiveUp {};

class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(DeckErrors& errors, PlaceFinder& places, int override)
      : errors_(errors), places_(places), override_(override) {}

  Node take_root() { return std::move(root_); }

  Spot spot(const YAML::Mark& mark) {
    return {override_ >= 0 ? Place{-override_ - 1, 0} : places_.place(mark.line, mark.column), override_};
  }

  /// The innermost list or map in brackets that is still open.
  const Node* innermost() const { return open_.empty() ? nullptr : &open_.back().node; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ == 0) return;
    errors_.add(spot(mark), "a second document begins (a deck is one document): remove the '---' and what follows it");
    throw GiveUp{};
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { add(make(Node::Kind::null, mark, "", anchor)); }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    Node node = make(Node::Kind::null, mark, "", 0);
    errors_.add(node.spot,
                "aliases are not supported (every value must be written where it is used): write the value itself");
    node.broken = true;
    add(std::move(node));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    Node node = make(Node::Kind::scalar, mark, tag, anchor);
    node.text = value;
    node.quoted = tag == "!";
    // At the end of the text yaml-cpp takes a quoted scalar for complete.
    if (node.quoted && !places_.is_quote_closed(mark.line, mark.column)) {
      errors_.add(node.spot, "not valid YAML (a quote is not closed)");
      throw GiveUp{};
    }
    add(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(make(Node::Kind::list, mark, tag, anchor));
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(make(Node::Kind::map, mark, tag, anchor));
  }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    Node node;
    bool wants_value = false;  // in a map: a key was read
    bool skip = false;         // the value of a bad key is read and dropped
    std::string name;
    Spot key;
    std::unordered_map<std::string, int> lines;  // of the keys so far
  };

  Node make(Node::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    if (++values_ > most_values) {
      errors_.add(spot(mark), fmt::format("the deck has more than {} values (the most a deck can have)", most_values));
      throw GiveUp{};
    }
    Node node;
    node.kind = kind;
    node.spot = node.key = spot(mark);
    if (anchor != 0)
      errors_.add(node.spot, "anchors are not supported (there are no aliases): remove the '&' and its name");
    if (!tag.empty() && tag != "?" && tag != "!") {
      errors_.add(node.spot, "tags are not supported (the keys give the types): remove the '!' and its name");
    }
    return node;
  }

  void open(Node node) {
    if (open_.size() >= deepest) {
      errors_.add(node.spot, fmt::format("maps and lists are nested deeper than {} (no deck needs that)", deepest));
      throw GiveUp{};
    }
    Open frame;
    frame.node = std::move(node);
    open_.push_back(std::move(frame));
  }

  void close() {
    Node node = std::move(open_.back().node);
    open_.pop_back();
    add(std::move(node));
  }

  void add(Node node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& frame = open_.back();
    if (frame.node.kind == Node::Kind::list) {
      frame.node.items.push_back(std::move(node));
    } else if (!frame.wants_value) {
      take_key(frame, node);
    } else {
      frame.wants_value = false;
      node.key = frame.key;
      if (node.kind == Node::Kind::null) node.spot = frame.key;  // an absent value is marked at what follows
      if (!frame.skip) frame.node.entries.push_back({std::move(frame.name), std::move(node)});
    }
  }

  void take_key(Open& frame, const Node& node) {
    frame.wants_value = true;
    frame.key = node.spot;
    frame.name = node.text;
    frame.skip = node.kind != Node::Kind::scalar;
    if (frame.skip) {
      if (!node.broken) errors_.add(node.spot, fmt::format("a key is {} (must be a word)", describe(node)));
      return;
    }
    const auto [first, is_new] = frame.lines.emplace(node.text, node.spot.place.line);
    frame.skip = !is_new;
    if (is_new) return;
    const std::string where = override_ >= 0 ? "" : fmt::format(" (first on line {})", first->second);
    errors_.add(node.spot, fmt::format("key {} is given twice{}: remove one", describe(node), where));
  }

  DeckErrors& errors_;
  PlaceFinder& places_;
  int override_;
  int documents_ = 0;
  std::size_t values_ = 0;
  Node root_;
  std::vector<Open> open_;
};

// yaml-cpp's terse reasons, with what to do about them.
std::string explain(const std::string& reason, const TreeBuilder& builder) {
  const Node* node = builder.innermost();
  const auto unclosed = [&](const char* bracket) {
    if (node == nullptr || node->spot.place.line <= 0) return fmt::format("a '{}' is not closed", bracket);
    return fmt::format("the '{}' of line {}, column {} is not closed", bracket, node->spot.place.line,
                       node->spot.place.column);
  };
  if (reason == "end of sequence flow not found") return unclosed("[") + " or a comma is missing";
  if (reason == "end of map flow not found") return unclosed("{") + " or a comma is missing";
  if (reason == "illegal flow end") return "this bracket closes nothing, or one opened before it is still open";
  if (reason == "illegal EOF in scalar") return "a quote is not closed";
  if (reason == "unknown token") return "a value cannot begin with this character: put it in quotes";
  if (reason == "illegal map value") return "a ':' does not belong here: check the line above it and its indentation";
  if (reason.starts_with("the referenced anchor is not defined"))  // yaml-cpp 0.8 adds the name
    return "aliases are not supported; to begin a text with '*', put it in quotes";
  return reason;
}

/// The word before a bracket that a line [from 0] begins with, as in "time {end: 1, step_scale: 0.9}", and its place.
std::optional<std::pair<std::string, Place>> find_word_before_bracket(const std::string& text, int line) {
  std::size_t start = 0;
  for (int i = 0; i < line; ++i) {
    start = text.find('\n', start);
    if (start++ == std::string::npos) return std::nullopt;
  }
  const std::string words = text.substr(start, text.find('\n', start) - start);
  const std::size_t first = words.find_first_not_of(' '), end = words.find_first_of(" :{[", first);
  const std::size_t bracket = words.find_first_not_of(' ', end);
  if (first == std::string::npos || end == first || bracket == std::string::npos || bracket == end) return std::nullopt;
  const bool is_word = words[first] != '-' && words[first] != '"' && words[first] != '\'';
  if (!is_word || (words[bracket] != '{' && words[bracket] != '[')) return std::nullopt;
  return std::pair(words.substr(first, end - first), Place{line + 1, static_cast<int>(first) + 1});
}

/// The first line up to `last` [from 0] that a tab indents, which yaml-cpp takes for text.
std::optional<Place> find_tab_indent(const std::string& text, int last) {
  std::size_t start = 0;
  for (int line = 0; line <= last && start < text.size(); ++line) {
    const std::size_t first = text.find_first_not_of(" \t", start);
    const std::size_t tab = text.find('\t', start);
    if (tab < first && first != std::string::npos && text[first] != '\n' && text[first] != '#')
      return Place{line + 1, static_cast<int>(tab - start) + 1};
    const std::size_t end = text.find('\n', start);
    if (end == std::string::npos) break;
    start = end + 1;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Node> parse_yaml(const std::string& text, DeckErrors& errors, int override) {
  PlaceFinder places(text);
  TreeBuilder builder(errors, places, override);
  std::istringstream stream(text);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
    return builder.take_root();
  } catch (const GiveUp&) {
    // reported already
  } catch (const YAML::DeepRecursion& error) {
    errors.add(builder.spot(error.mark), "maps and lists are nested too deep (no deck needs that)");
  } catch (const YAML::ParserException& error) {
    const auto tab = override < 0 ? find_tab_indent(text, error.mark.line) : std::nullopt;
    const auto word = override < 0 ? find_word_before_bracket(text, error.mark.line) : std::nullopt;
    if (tab)
      errors.add({*tab, override}, "not valid YAML (a tab indents this line): indent with spaces");
    else if (word)
      errors.add({word->second, override},
                 fmt::format("not valid YAML (a colon is missing after {})", quote(word->first)));
    else
      errors.add(builder.spot(error.mark), "not valid YAML (" + explain(error.msg, builder) + ")");
  }
  return std::nullopt;
}

}  // namespace percuss
