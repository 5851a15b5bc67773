#pragma once
// The content of a checkpoint, for saving and loading. One list serves both: the owner of state that a restart needs
// names it in a function `void archive(CheckpointArchive&)`, one line each.
//
// Nothing in a checkpoint depends on ranks or threads. An array is stored chunk after chunk, and a rank writes or reads
// the rows of its chunks. Numbers are the same on every rank; exact sums are those of all ranks.

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "kernels/core/exact_sum.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {

struct ChunkedMesh;

/// Rows of an array by chunk.
struct ChunkRows {
  std::vector<std::int64_t> counts;  // [chunks of this rank, ascending number] rows that each has
  std::vector<int> places;           // [rows] where each stands in this rank's array; empty: in their order from 0
};

/// A row an element, or `size` of them, of every chunk of this rank.
ChunkRows find_element_rows(const ChunkedMesh& mesh);

/// A row a node: those that this rank owns, of arrays over all nodes that it holds. What is read reaches no copies.
ChunkRows find_owned_node_rows(const ChunkedMesh& mesh);

/// Rows that belong to some of the nodes that this rank owns. numbers: [rows] of the nodes in the whole mesh,
/// ascending; a node may have several rows.
ChunkRows find_rows_of_nodes(const ChunkedMesh& mesh, std::span<const std::int64_t> numbers);

/// Names are unique within a checkpoint, with '/' between the stage that owns the state and what it is. Every call is
/// collective. Throws SystemError when saving; InputError, on all ranks, when loading what is not there, has another
/// size, or is a value that cannot be: a double that is not finite, an integer that its type does not hold.
class CheckpointArchive {
 public:
  virtual ~CheckpointArchive() = default;

  virtual bool is_loading() const = 0;

  /// Loading: whether there is a number of this name, for state that a run may begin without. Saving: true.
  virtual bool has_number(const std::string& name) const = 0;

  /// Numbers that all ranks know: integers, or the bits of doubles.
  virtual void words(const std::string& name, std::span<std::int64_t> values) = 0;

  /// A number that all ranks know.
  void number(const std::string& name, double& value) { numbers(name, std::span(&value, 1)); }
  void number(const std::string& name, std::int64_t& value) { words(name, std::span(&value, 1)); }

  /// Several of one name.
  void numbers(const std::string& name, std::span<double> values) {
    each(name, values, [](double& value, const auto& take) { take(value); });
  }

  /// Saves or loads the rows of a list under one name. visit(row, take): calls take(...) with all numbers of a row,
  /// doubles or 64-bit integers.
  template <class Rows, class Visit>
  void each(const std::string& name, Rows&& rows, const Visit& visit) {
    std::vector<std::int64_t> all;
    for (auto& row : rows)
      visit(row, [&](const auto&... values) { (all.push_back(std::bit_cast<std::int64_t>(values)), ...); });
    words(name, all);
    if (!is_loading()) return;
    auto next = all.begin();
    for (auto& row : rows) visit(row, [&](auto&... values) { (load_word(name, *next++, values), ...); });
  }

  /// A number that is infinite where there is no limit; never NaN. In the file it is like any other.
  void number_or_infinity(const std::string& name, double& value) {
    auto bits = std::bit_cast<std::int64_t>(value);
    number(name, bits);
    value = std::bit_cast<double>(bits);
    if (is_loading() && std::isnan(value)) refuse_value(name);
  }

  /// A sum of which each rank has a share. Loaded, the whole of it is rank 0's share.
  virtual void sum(const std::string& name, ExactSum& value) = 0;

  /// An array of rows of so many components, row by row, on the host.
  virtual void rows(const std::string& name, const ChunkRows& rows, int components, std::span<double> values) = 0;
  virtual void rows(const std::string& name, const ChunkRows& rows, int components, std::span<std::int64_t> values) = 0;

  /// Checks rows whose number the checkpoint itself gives, before memory is taken for them. counts: [chunks of this
  /// rank] rows that each is to have, negative for a number that cannot be. Loading, throws InputError, on all ranks,
  /// if the array has another number of rows.
  virtual void expect_rows(const std::string& name, std::span<const std::int64_t> counts, int components) = 0;

  /// rows() for a view of any shape whose memory has the rows one after the other.
  template <class View>
  requires Kokkos::is_view<View>::value void rows(const std::string& name, const ChunkRows& chunk_rows, int components,
                                                  const View& view) {
    using Value = typename View::non_const_value_type;
    const auto host = to_host(view);
    rows(name, chunk_rows, components, std::span<Value>(host.data(), host.size()));
    if (is_loading()) copy_values(view, host);
  }

  /// Several sums of one name: NAME/0, NAME/1 ...
  void sums(const std::string& name, std::span<ExactSum> values) {
    for (std::size_t i = 0; i < values.size(); ++i) sum(name + "/" + std::to_string(i), values[i]);
  }

  /// A number of another type (bool, int, long, enum).
  template <class Value>
  void integer(const std::string& name, Value& value) {
    auto wide = static_cast<std::int64_t>(value);
    number(name, wide);
    value = static_cast<Value>(wide);
    if (static_cast<std::int64_t>(value) != wide) refuse_value(name);
  }

 protected:
  /// Loading: what the checkpoint says under this name, on all ranks alike, cannot be. Throws InputError.
  [[noreturn]] virtual void refuse_value(const std::string& name) const = 0;

 private:
  void load_word(const std::string& /*name*/, std::int64_t word, std::int64_t& value) const { value = word; }
  void load_word(const std::string& name, std::int64_t word, double& value) const {
    value = std::bit_cast<double>(word);
    if (!std::isfinite(value)) refuse_value(name);
  }
};

}  // namespace percuss
