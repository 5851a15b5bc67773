#pragma once
// Tables of keys: each row names a key, whether it must be there, the member that it fills and the reader of its value.
// From the same tables come unknown-key hints, missing-key errors, the list that docs/deck.md is checked against and
// the schema for editors.

#include <bit>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/deck/keys/values.hpp"
#include "src/deck/text/nearest_name.hpp"

namespace percuss {

/// How the value of a key is read into its owner, and its form. The owner's type is known to the table alone: keys of
/// all owners whose values are of one kind share one class, since tables have hundreds of keys.
class KeyValue {
 public:
  virtual ~KeyValue() = default;
  virtual bool read(const Reader& reader, const Node& node, void* owner) const = 0;
  virtual Form form() const = 0;
};

/// A row of a table, whatever it belongs to.
struct AnyKey {
  std::string name;
  bool required = false;
  std::string takes;
  std::shared_ptr<const KeyValue> value;
};

/// A row of a table of the owner's.
template <class Owner>
struct Key : AnyKey {};

/// The rows that fill an owner.
template <class Owner>
struct Keys : std::vector<AnyKey> {
  Keys() = default;
  Keys(std::initializer_list<Key<Owner>> rows) {
    for (const Key<Owner>& row : rows) push_back(row);
  }
};

template <class Owner>
Key<Owner> own_key(std::string name, bool required, std::string takes, const KeyValue* value) {
  return {{std::move(name), required, std::move(takes), std::shared_ptr<const KeyValue>(value)}};
}

/// A row whose value is read by `read(value, reader, name, node, owner)`.
template <class Owner, class Value, class Read>
Key<Owner> make_key(std::string name, bool required, Value value, Read read) {
  class Row final : public KeyValue {
   public:
    Row(std::string n, Value v, Read r) : name_(std::move(n)), value_(std::move(v)), read_(std::move(r)) {}
    bool read(const Reader& reader, const Node& node, void* owner) const override {
      return read_(value_, reader, reader.name_of(name_), node, *static_cast<Owner*>(owner));
    }
    Form form() const override { return value_.form(); }

   private:
    std::string name_;
    Value value_;
    Read read_;
  };
  std::string takes = value.takes();
  const KeyValue* const row = new Row(name, std::move(value), std::move(read));
  return own_key<Owner>(std::move(name), required, std::move(takes), row);
}

/// Where a member lies in its owner [bytes]. The C++ ABI of GCC and Clang defines a pointer to a data member as that.
template <class Owner, class Member>
std::ptrdiff_t find_offset(Member Owner::*member) {
  static_assert(sizeof(member) == sizeof(std::ptrdiff_t));
  return std::bit_cast<std::ptrdiff_t>(member);
}

/// A key of a member of the owner as one of the owner itself. part: offset of the member.
AnyKey lift_any_key(const AnyKey& key, std::ptrdiff_t part);
template <class Owner, class Part>
Key<Owner> lift_key(const AnyKey& key, Part Owner::*part) {
  return {lift_any_key(key, find_offset(part))};
}

/// Reads a value into a member.
template <class Member, class Value>
class MemberValue final : public KeyValue {
 public:
  MemberValue(std::string name, Value value, std::ptrdiff_t offset)
      : name_(std::move(name)), value_(std::move(value)), offset_(offset) {}
  bool read(const Reader& reader, const Node& node, void* owner) const override {
    Member& member = *reinterpret_cast<Member*>(static_cast<char*>(owner) + offset_);
    if constexpr (requires { member.has_value(); }) {
      typename Member::value_type inner{};
      if (!value_.read(reader, reader.name_of(name_), node, inner)) return false;
      member = std::move(inner);
      return true;
    } else {
      return value_.read(reader, reader.name_of(name_), node, member);
    }
  }
  Form form() const override { return value_.form(); }

 private:
  std::string name_;
  Value value_;
  std::ptrdiff_t offset_;
};

template <class Owner, class Member, class Value>
Key<Owner> member_key(std::string name, bool required, Member Owner::*member, Value value) {
  std::string takes = value.takes();
  const KeyValue* const row = new MemberValue<Member, Value>(name, std::move(value), find_offset(member));
  return own_key<Owner>(std::move(name), required, std::move(takes), row);
}

/// A key that must be there, and the member that it fills.
template <class Owner, class Member, class Value>
Key<Owner> need(std::string name, Member Owner::*member, Value value) {
  return member_key(std::move(name), true, member, std::move(value));
}

/// A key that may be absent; the member's initial value is the default.
template <class Owner, class Member, class Value>
Key<Owner> may(std::string name, Member Owner::*member, Value value) {
  return member_key(std::move(name), false, member, std::move(value));
}

/// A key whose value fills members of the owner itself (a map that groups them).
template <class Owner, class Value>
Key<Owner> group(std::string name, Value value) {
  return make_key<Owner>(std::move(name), false, std::move(value),
                         [](const Value& v, const Reader& reader, const std::string& full, const Node& node,
                            Owner& owner) { return v.read(reader, full, node, owner); });
}

/// Keys of the same map that another table reads, and a better hint for keys that are unknown here (or nothing).
struct OtherKeys {
  std::vector<std::string> names;
  std::function<std::string(const std::string& name)> hint;
};

/// Tells that a key is unknown; returns what it is probably meant to be, of the known ones, or nothing.
std::string refuse_key(const Reader& reader, const Entry& entry, const std::vector<std::string>& known,
                       const OtherKeys& others);
void refuse_missing(const Reader& reader, const Node& node, const std::string& name, const std::string& takes);

/// Whether a map has the key, be it without the colon behind it.
bool is_there(const Node& node, const std::string& name);

/// Reads a map by its table: unknown keys get a hint, missing ones an error, unless a hint names them. owner: what the
/// rows fill. Returns whether all went well.
bool read_any_keys(const Reader& reader, const Node& node, const std::vector<AnyKey>& keys, void* owner,
                   const OtherKeys& others);
template <class Owner>
bool read_keys(const Reader& reader, const Node& node, const Keys<Owner>& keys, Owner& out,
               const OtherKeys& others = {}) {
  return read_any_keys(reader, node, keys, &out, others);
}

Form form_of(const std::vector<AnyKey>& keys);

/// A map read by its table; `check` then sees to what concerns several keys, if each was read without error.
template <class T>
struct MapValue {
  const Keys<T>& (*keys)();
  bool (*check)(const Reader&, const Node&, T&) = nullptr;

  bool read(const Reader& reader, const std::string& name, const Node& node, T& out) const {
    return reader.expect(node, Node::Kind::map, name, takes()) && read_inside(reader.inside(name), node, out);
  }
  bool read_inside(const Reader& inner, const Node& node, T& out) const {
    return read_keys(inner, node, keys(), out) && (check == nullptr || check(inner, node, out));
  }
  std::string takes() const { return "a map"; }
  Form form() const { return form_of(keys()); }
};

/// A map from names that the user gives to things of one kind ("part", "material"); T has `name` and `place`.
template <class T, class Inner>
struct NamedMapValue {
  std::string kind;
  Inner inner;

  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<T>& out) const {
    if (!reader.expect(node, Node::Kind::map, name, takes())) return false;
    bool good = true;
    for (const Entry& entry : node.entries) {
      T item{};
      item.name = entry.name;
      item.place = entry.value.key.place;
      const Reader named = reader.inside_named(kind, entry.name);
      good = check_name(reader, entry) && good;
      if (entry.value.broken || !reader.expect(entry.value, Node::Kind::map, kind + " '" + entry.name + "'", "a map") ||
          !inner.read_inside(named, entry.value, item)) {
        good = false;
      }
      out.push_back(std::move(item));  // even if bad: its name exists
    }
    return good;
  }

  std::string takes() const { return "a map from names to maps"; }
  Form form() const {
    Form form{Form::Kind::named_maps};
    form.inner.push_back(inner.form());
    return form;
  }

 private:
  bool check_name(const Reader& reader, const Entry& entry) const {
    if (is_name(entry.name) && entry.name != "all") return true;
    reader.error(entry.value.key,
                 fmt::format("{} name {} cannot be used (must be letters, digits, '_' or '-', begin with a "
                             "letter, and not be the word all)",
                             kind, quote(entry.name)));
    return false;
  }
};

}  // namespace percuss
