#include "src/deck/laws/law_code.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <new>
#include <set>

#include "kernels/material/user/library_law.hpp"
#include "kernels/material/user/user_call.hpp"
#include "src/deck/laws/make_law.hpp"
#include "src/deck/laws/user_code.hpp"
#include "src/deck/range.hpp"
#include "src/deck/text/nearest_name.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

const LawLibrary& find_library(const std::string& file, void* handle) {
  const char* const remedy = "make it by percuss build-law of this version of percuss";
  void* const entry = ::dlsym(handle, "percuss_law");
  if (entry == nullptr) refuse_library(file, "it has no entry percuss_law", remedy);
  const LawLibrary& library = *reinterpret_cast<const LawLibrary* (*)()>(entry)();
  if (!(library.layout == law_layout)) refuse_library(file, "it was made for another percuss", remedy);
  if (library.history_count > LibraryLaw::history_count)
    refuse_library(
        file, fmt::format("its history has {} numbers, more than {}", library.history_count, LibraryLaw::history_count),
        "store less");
  return library;
}

[[noreturn]] void refuse_constant(const std::string& file, const std::string& constant, const std::string& why,
                                  const std::string& remedy) {
  throw InputError(fmt::format("{}: error: constants.{} of this law {}: {}", file, constant, why, remedy));
}

const char* describe_kind(LawKeyKind kind) {
  switch (kind) {
    case LawKeyKind::number:
      return "a number";
    case LawKeyKind::integer:
      return "an integer";
    case LawKeyKind::word:
      return "a word";
    case LawKeyKind::vector:
      return "three numbers";
    case LawKeyKind::table:
      return "a table [[x, y], ...]";
  }
  return "";
}

std::string name_constants(const LawLibrary& library) {
  std::string names;
  for (int i = 0; i < library.key_count; ++i) names += fmt::format("{}{}", i > 0 ? ", " : "", library.keys[i].name);
  return names;
}

/// All constants that the deck gives.
std::set<std::string> list_given(const LawDeck& law) {
  const std::string prefix = name_library_constant("");
  std::set<std::string> names;
  const auto add = [&](const auto& map) {
    for (const auto& [name, value] : map)
      if (name.starts_with(prefix)) names.insert(name.substr(prefix.size()));
  };
  add(law.numbers), add(law.texts), add(law.vectors), add(law.tables);
  return names;
}

void check_names(const LawDeck& law, const std::string& file, const LawLibrary& library) {
  for (const std::string& given : list_given(law)) {
    const auto is_it = [&](const LawKey& key) { return given == key.name; };
    if (std::any_of(library.keys, library.keys + library.key_count, is_it)) continue;
    std::vector<std::string> names(static_cast<std::size_t>(library.key_count));
    std::transform(library.keys, library.keys + library.key_count, names.begin(),
                   [](const LawKey& key) { return key.name; });
    const std::string near = nearest_name(given, names);
    refuse_constant(file, given, "is unknown",
                    near.empty() ? "it has " + name_constants(library) : "did you mean '" + near + "'?");
  }
}

void check_range(const std::string& file, const LawKey& key, double value) {
  const Range& range = find_range(key.range);
  if (!range.holds(value)) refuse_constant(file, key.name, fmt::format("is {}", value), "must be " + range.text);
  if (key.kind == LawKeyKind::integer && !(value >= 0 && value <= key.most && value == static_cast<int>(value)))
    refuse_constant(file, key.name, fmt::format("is {}", value), fmt::format("an integer from 0 to {}", key.most));
}

/// The value of a constant; false: the deck has none of its kind.
bool read_value(const LawDeck& law, const std::string& file, const LawKey& key, LawValue& value) {
  const std::string name = name_library_constant(key.name);
  if (key.kind == LawKeyKind::table && law.tables.contains(name)) {
    value.table = make_table(law.tables.at(name));
    for (int i = 0; i < value.table.rows; ++i) check_range(file, key, value.table.y[i]);
    return true;
  }
  if (key.kind == LawKeyKind::vector && law.vectors.contains(name)) {
    std::copy(law.vectors.at(name).begin(), law.vectors.at(name).end(), value.vector);
    return true;
  }
  if (key.kind == LawKeyKind::word && law.texts.contains(name)) {
    const std::string& word = law.texts.at(name);
    if (word != key.words[0] && word != key.words[1])
      refuse_constant(file, key.name, fmt::format("is '{}'", word),
                      fmt::format("{} or {}", key.words[0], key.words[1]));
    value.number = word == key.words[1] ? 1 : 0;
    return true;
  }
  if ((key.kind == LawKeyKind::number || key.kind == LawKeyKind::integer) && law.numbers.contains(name)) {
    value.number = law.numbers.at(name);
    check_range(file, key, value.number);
    return true;
  }
  return false;
}

std::vector<LawValue> read_values(const LawDeck& law, const std::string& file, const LawLibrary& library) {
  check_names(law, file, library);
  const std::set<std::string> given = list_given(law);
  std::vector<LawValue> values(static_cast<std::size_t>(library.key_count));
  for (int i = 0; i < library.key_count; ++i) {
    const LawKey& key = library.keys[i];
    LawValue& value = values[static_cast<std::size_t>(i)];
    value.is_given = read_value(law, file, key, value);
    if (!value.is_given && (key.is_required || given.contains(key.name)))
      refuse_constant(file, key.name, given.contains(key.name) ? "is of another kind" : "is missing",
                      std::string("it is ") + describe_kind(key.kind));
  }
  return values;
}

/// All that a made law depends on, as one text.
std::string describe_constants(const LawDeck& law, const std::string& file) {
  return fmt::format("{}\n{}\n{}\n{}\n{}", file, law.numbers, law.texts, law.vectors, law.tables);
}

}  // namespace

MadeLaw make_law_of_library(const LawDeck& law, const std::string& file) {
  static std::mutex busy;
  static std::map<std::string, MadeLaw> all;  // laws stay for the whole run: elements point at them
  const LoadedLibrary loaded = load_library(file);
  const std::scoped_lock lock(busy);
  const std::string key = describe_constants(law, file);
  if (const auto known = all.find(key); known != all.end()) return known->second;
  const LawLibrary& library = find_library(file, loaded.handle);
  const std::vector<LawValue> values = read_values(law, file, library);
  void* const place = ::operator new (library.size, std::align_val_t{library.alignment});
  const char* fault = nullptr;
  call_library(loaded.file, [&] { fault = library.make(values.data(), place); });
  if (fault != nullptr) throw InputError(fmt::format("{}: error: the constants of this law have {}", file, fault));
  return all[key] = MadeLaw{&library, place, loaded.has_written_outside, loaded.file};
}

}  // namespace percuss
