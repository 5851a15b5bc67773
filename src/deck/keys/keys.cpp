#include "src/deck/keys/keys.hpp"

#include <algorithm>

#include "src/deck/keys/foreign_names.hpp"

namespace percuss {

namespace {

/// Whether a key is all digits: in {end: 1,5} YAML reads what stands behind the comma as a key without a value.
bool is_digits(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// "time" of "time {end", which is the key in "time {end: 1}", where a colon is missing; empty: of another key.
std::string find_key_without_colon(const std::string& name) {
  const auto bracket = name.find_first_of("{[");
  if (bracket == std::string::npos || bracket == 0) return {};
  const auto last = name.find_last_not_of(' ', bracket - 1);
  return last == std::string::npos || !is_name(name.substr(0, last + 1)) ? std::string() : name.substr(0, last + 1);
}

/// A key of a member as one of its owner.
class LiftedValue final : public KeyValue {
 public:
  LiftedValue(std::shared_ptr<const KeyValue> value, std::ptrdiff_t part) : value_(std::move(value)), part_(part) {}
  bool read(const Reader& reader, const Node& node, void* owner) const override {
    return value_->read(reader, node, static_cast<char*>(owner) + part_);
  }
  Form form() const override { return value_->form(); }

 private:
  std::shared_ptr<const KeyValue> value_;
  std::ptrdiff_t part_;
};

}  // namespace

AnyKey lift_any_key(const AnyKey& key, std::ptrdiff_t part) {
  return {key.name, key.required, key.takes, std::make_shared<LiftedValue>(key.value, part)};
}

bool is_there(const Node& node, const std::string& name) {
  return std::any_of(node.entries.begin(), node.entries.end(), [&](const Entry& entry) {
    return entry.name == name || find_key_without_colon(entry.name) == name;
  });
}

std::string refuse_key(const Reader& reader, const Entry& entry, const std::vector<std::string>& known,
                       const OtherKeys& others) {
  std::string hint = others.hint ? others.hint(entry.name) : "";
  if (hint.empty()) hint = find_foreign_key(entry.name, known);
  if (hint.empty()) hint = name_hint(entry.name, known);
  const auto named = std::find_if(known.begin(), known.end(),
                                  [&](const std::string& key) { return hint.find(quote(key)) != std::string::npos; });
  // {a:1} is one key "a:1" in YAML, and "a b" without a colon is a key with nothing.
  const auto colon = entry.name.find(':');
  if (colon != std::string::npos) {
    hint = fmt::format(" (a space must follow the colon: '{}: {}')", entry.name.substr(0, colon),
                       entry.name.substr(colon + 1));
  }
  if (const std::string key = find_key_without_colon(entry.name); !key.empty())
    hint = fmt::format(" (a colon is missing after {})", quote(key));
  if (entry.value.kind == Node::Kind::null && is_digits(entry.name)) hint = " (decimals take a point, not a comma)";
  const std::string where = reader.self() == "the deck" ? "" : " in " + reader.self();
  reader.error(entry.value.key, fmt::format("unknown key {}{}{}", quote(entry.name), where, hint));
  return named == known.end() ? nearest_name(entry.name, known) : *named;
}

void refuse_missing(const Reader& reader, const Node& node, const std::string& name, const std::string& takes) {
  if (node.broken) return;
  reader.error(node.key, fmt::format("{} is missing{} (required: {})", reader.name_of(name), reader.in(), takes));
}

bool read_any_keys(const Reader& reader, const Node& node, const std::vector<AnyKey>& keys, void* owner,
                   const OtherKeys& others) {
  std::vector<std::string> known = others.names;
  for (const AnyKey& key : keys) known.push_back(key.name);
  std::vector<std::string> hinted;  // what unknown keys are probably meant to be
  bool good = true;
  for (const Entry& entry : node.entries) {
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const AnyKey& k) { return k.name == entry.name; });
    if (key != keys.end()) {
      good = !entry.value.broken && key->value->read(reader, entry.value, owner) && good;
    } else if (std::find(others.names.begin(), others.names.end(), entry.name) == others.names.end()) {
      hinted.push_back(refuse_key(reader, entry, known, others));
      good = false;
    }
  }
  for (const AnyKey& key : keys) {
    if (!key.required || is_there(node, key.name)) continue;
    good = false;
    if (std::find(hinted.begin(), hinted.end(), key.name) == hinted.end())
      refuse_missing(reader, node, key.name, key.takes);
  }
  return good;
}

Form form_of(const std::vector<AnyKey>& keys) {
  Form form = map_form({});
  for (const AnyKey& key : keys) form.keys.push_back({key.name, key.required, key.takes, key.value->form()});
  return form;
}

}  // namespace percuss
