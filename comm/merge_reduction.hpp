#pragma once
// A reduction over ranks of one struct, by a merge of its own: sums, least keys and lists in a single message.

#include <span>
#include <type_traits>

#include "comm/communicator.hpp"

namespace percuss {

/// T is trivially copyable and has `void merge(const T& other)`, which must be associative, commutative and exact, so
/// that every rank gets the same bits for any order that MPI takes. Made once, between MPI's start and end.
template <class T>
class MergeReduction {
  static_assert(std::is_trivially_copyable_v<T>, "a reduced struct travels as bytes");

 public:
  /// Throws MpiError.
  MergeReduction() {
    check_mpi(MPI_Type_contiguous(static_cast<int>(sizeof(T)), MPI_BYTE, &type_), "MPI_Type_contiguous");
    check_mpi(MPI_Type_commit(&type_), "MPI_Type_commit");
    check_mpi(MPI_Op_create(&merge_all, 1, &operation_), "MPI_Op_create");
  }
  ~MergeReduction() {
    MPI_Op_free(&operation_);
    MPI_Type_free(&type_);
  }
  MergeReduction(const MergeReduction&) = delete;
  MergeReduction& operator=(const MergeReduction&) = delete;

  /// value: in, this rank's; out, the merge of all. Collective. Throws MpiError.
  void operator()(const Communicator& ranks, T& value) const { (*this)(ranks, std::span<T>(&value, 1)); }

  /// Reduces several values, as many on every rank, in one message.
  void operator()(const Communicator& ranks, std::span<T> values) const {
    const int count = static_cast<int>(values.size());
    wait_mpi([&] { return MPI_Allreduce(MPI_IN_PLACE, values.data(), count, type_, operation_, ranks.handle()); },
             "MPI_Allreduce");
  }

 private:
  static void merge_all(void* in, void* in_out, int* count, MPI_Datatype*) {
    for (int i = 0; i < *count; ++i) static_cast<T*>(in_out)[i].merge(static_cast<const T*>(in)[i]);
  }

  MPI_Datatype type_ = MPI_DATATYPE_NULL;
  MPI_Op operation_ = MPI_OP_NULL;
};

}  // namespace percuss
