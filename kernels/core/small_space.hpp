#pragma once
// Where a contact kernel runs: little work runs in the calling thread, because waking threads would cost more. On a
// device all work runs there, because the calling thread does not see its memory.
//
// Every contact kernel gives the same bits in either space. On the host it is compiled once for both: as a loop over a
// part of its items, which run_parts() calls.

#include <numeric>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "kernels/core/simd.hpp"
#include "kernels/core/views.hpp"

#if defined(KOKKOS_ENABLE_SERIAL) && !defined(PERCUSS_BACKEND_SERIAL) && !defined(PERCUSS_ON_DEVICE) && \
    !defined(PERCUSS_MEMORY_APART)
#define PERCUSS_SMALL_SPACE 1
#endif

namespace percuss {

#if defined(PERCUSS_SMALL_SPACE)
using SmallSpace = Kokkos::Serial;
#else
using SmallSpace = ExecSpace;
#endif
static_assert(Kokkos::SpaceAccessibility<SmallSpace, MemSpace>::accessible, "both spaces work on the same views");

/// One of the two spaces, chosen as the program runs.
class WorkSpace {
 public:
  WorkSpace(const ExecSpace& all) : all_(all) {}
#if defined(PERCUSS_SMALL_SPACE)
  WorkSpace(const SmallSpace&) : is_small_(true) {}
#endif

  bool is_small() const { return is_small_; }
  const ExecSpace& all() const { return all_; }
  int concurrency() const { return is_small_ ? 1 : all_.concurrency(); }
  void fence() const {
    if (!is_small_) all_.fence();
  }

 private:
  ExecSpace all_;
  bool is_small_ = false;
};

/// Items first to last - 1 of a kernel.
struct RangeOf {
  RangeOf(const WorkSpace& in, int from, int to) : space(in), first(from), last(to) {}
  WorkSpace space;
  int first, last;
};

/// Calls run(kernel, begin, end, part) for contiguous parts of a range, one a thread, and waits for them.
void run_parts(const char* label, const RangeOf& range, void (*run)(const void*, int, int, int), const void* kernel);

/// Adds up in a reduction, where no reducer of Kokkos is given.
template <class T>
struct SumReducer {
  using value_type = T;
  T& result;
  void init(T& value) const { value = T{}; }
  void join(T& to, const T& from) const { to += from; }
  T& reference() const { return result; }
};
template <class Result>
auto find_reducer(Result& result) {
  if constexpr (requires { typename Result::reducer; })
    return result;
  else
    return SumReducer<Result>{result};
}

/// Parts of a range with what each adds up, of any number of threads the same where sums are of integers.
template <class Kernel, class... Reducer>
class Reduction {
 public:
  Reduction(const Kernel& kernel, int parts, const Reducer&... reducer)
      : kernel_(kernel), reducers_(reducer...), partial_(static_cast<std::size_t>(parts)) {
    for (Partial& partial : partial_) std::apply([&](auto&... value) { (reducer.init(value), ...); }, partial.values);
  }

  void run(const char* label, const RangeOf& range) {
    const auto add = [](const void* self, int begin, int end, int part) {
      static_cast<const Reduction*>(self)->add(begin, end, part);
    };
    run_parts(label, range, add, this);
    std::apply([&](const auto&... reducer) { (reducer.init(reducer.reference()), ...); }, reducers_);
    for (const Partial& partial : partial_) join(partial.values, std::index_sequence_for<Reducer...>());
  }

 private:
  using Values = std::tuple<typename Reducer::value_type...>;
  struct alignas(64) Partial {
    mutable Values values;
  };

  void add(int begin, int end, int part) const {
    const Partial& partial = partial_[static_cast<std::size_t>(part)];
    Values values = partial.values;
    std::apply(
        [&](auto&... value) {
          for (int i = begin; i < end; ++i) kernel_(i, value...);
        },
        values);
    partial.values = values;
  }
  template <std::size_t... I>
  void join(const Values& values, std::index_sequence<I...>) {
    (std::get<I>(reducers_).join(std::get<I>(reducers_).reference(), std::get<I>(values)), ...);
  }

  const Kernel& kernel_;
  std::tuple<Reducer...> reducers_;
  std::vector<Partial> partial_;
};

/// As those of Kokkos, over the items of a range.
template <class Kernel>
void parallel_for(const char* label, const RangeOf& range, const Kernel& kernel) {
#ifdef PERCUSS_ON_DEVICE
  Kokkos::parallel_for(label, Range(range.space.all(), range.first, range.last), kernel);
#else
  const auto run = [](const void* of, int begin, int end, int) {
    for (int i = begin; i < end; ++i) (*static_cast<const Kernel*>(of))(i);
  };
  run_parts(label, range, run, &kernel);
#endif
}

template <class Kernel, class... Result>
void parallel_reduce(const char* label, const RangeOf& range, const Kernel& kernel, Result&&... result) {
#ifdef PERCUSS_ON_DEVICE
  Kokkos::parallel_reduce(label, Range(range.space.all(), range.first, range.last), kernel,
                          std::forward<Result>(result)...);
#else
  Reduction(kernel, range.space.concurrency(), find_reducer(result)...).run(label, range);
#endif
}

template <class Kernel, class T>
void parallel_scan(const char* label, const RangeOf& range, const Kernel& kernel, T& total) {
#ifdef PERCUSS_ON_DEVICE
  Kokkos::parallel_scan(label, Range(range.space.all(), range.first, range.last), kernel, total);
#else
  struct Call {
    const Kernel& kernel;
    std::vector<T> sums;
    bool is_final;
  };
  const auto run = [](const void* of, int begin, int end, int part) {
    auto& [call, sums, is_final] = *static_cast<Call*>(const_cast<void*>(of));
    T sum = sums[static_cast<std::size_t>(part)];
    for (int i = begin; i < end; ++i) call(i, sum, is_final);
    sums[static_cast<std::size_t>(part)] = sum;
  };
  Call call{kernel, std::vector<T>(static_cast<std::size_t>(range.space.concurrency())), false};
  if (call.sums.size() > 1) {
    run_parts(label, range, run, &call);
    std::exclusive_scan(call.sums.begin(), call.sums.end(), call.sums.begin(), T{});
  }
  call.is_final = true;
  run_parts(label, range, run, &call);
  total = call.sums.back();
#endif
}

/// Calls work(space) with the space that suits `items` items of about the cost of a contact pair.
template <class Work>
void run_where_it_pays(int items, Work&& work) {
  constexpr int worth_threads = 1000;  // items: a hundred microseconds or more, against some to wake the threads
  work(items < worth_threads ? WorkSpace(SmallSpace()) : WorkSpace(ExecSpace()));
}

/// Calls loop(i) for each i below `count`, in the space that suits `items` items, and waits for it.
template <class Loop>
void loop_where_it_pays(const char* name, int count, int items, const Loop& loop) {
  run_where_it_pays(items, [&](const WorkSpace& space) {
    parallel_for(name, RangeOf(space, 0, count), loop);
    space.fence();
  });
}

/// Makes room for n items, with some to spare; contents are lost when it grows.
template <class View>
void reserve(View& view, int n) {
  const auto wanted = static_cast<std::size_t>(n);
  if (view.extent(0) >= wanted) return;
  const std::string label = view.label();
  view = View();  // the old memory goes before the new comes
  view = View(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), wanted + wanted / 2);
}

/// Makes room for n items without losing the first `kept`.
template <class View>
void keep_and_reserve(const WorkSpace& space, View& view, int kept, int n) {
  if (view.extent(0) >= static_cast<std::size_t>(n)) return;
  const View old = view;
  view = View(old.label(), 0);
  reserve(view, n);
  const View fresh = view;
  parallel_for(
      "contact::keep", RangeOf(space, 0, kept), KOKKOS_LAMBDA(int i) { fresh(i) = old(i); });
}

}  // namespace percuss
