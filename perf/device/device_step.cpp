// The element step on whatever back end Kokkos has: a box of hexahedra takes steps of forces, assembly and motion.
// Prints nanoseconds an element by kernel, the bytes that they move at least, the share of the measured memory
// bandwidth, what is conserved, and a hash of positions and velocities, which is the same on a device and on a host.
//
// usage: device_step [--cells N]... [--chunk N] [--steps N] [--repeats N] [--only NAME] [--write FILE] [--compare FILE]

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/same_bits.hpp"
#include "kernels/core/simd.hpp"
#include "perf/device/box_chunks.hpp"

namespace {

using namespace percuss;

#ifdef PERCUSS_ON_DEVICE
constexpr bool is_device = true;
constexpr int lanes = device_lanes;
#else
constexpr bool is_device = false;
constexpr int lanes = pack_size<Real>;
#endif

struct Options {
  std::vector<int> cells;
  int chunk = 8, steps = 100, repeats = 7;
  std::string only, write, compare;
};

/// Median of the seconds of one call of `work`, which is called some times between two readings of the clock.
template <class Work>
double time_median(int repeats, const Work& work) {
  constexpr int calls = is_device ? 20 : 2;
  std::vector<double> seconds;
  work();
  for (int r = 0; r < repeats; ++r) {
    Kokkos::fence();
    const Kokkos::Timer timer;
    for (int i = 0; i < calls; ++i) work();
    Kokkos::fence();
    seconds.push_back(timer.seconds() / calls);
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

/// Bytes a second of a = b + s c, past any cache.
double measure_triad(int repeats) {
  const int n = is_device ? 1 << 27 : 1 << 24;
  const Array<double> a("a", static_cast<std::size_t>(n)), b("b", a.extent(0)), c("c", a.extent(0));
  Kokkos::parallel_for(
      "triad_fill", Range(0, n), KOKKOS_LAMBDA(const int i) {
        b(i) = 1 + 1e-9 * i;
        c(i) = 2 - 3e-9 * i;
      });
  const double seconds = time_median(repeats, [&] {
    Kokkos::parallel_for(
        "triad", Range(0, n), KOKKOS_LAMBDA(const int i) { a(i) = b(i) + 0.5 * c(i); });
  });
  return 3.0 * sizeof(double) * n / seconds;
}

double find_least(const Array<double>& values) {
  double least = 0;
  Kokkos::parallel_reduce(
      "least", Range(0, static_cast<int>(values.extent(0))),
      KOKKOS_LAMBDA(const int i, double& min) { min = values(i) < min ? values(i) : min; }, Kokkos::Min<double>(least));
  return least;
}

/// Positions and velocities, on the host.
struct Motion {
  std::vector<double> x, v;
};

std::vector<double> list_numbers(const Rows3<double>& rows) {
  const auto host = to_host(rows);
  return {host.data(), host.data() + host.size()};
}

std::uint64_t hash_bits(const Motion& motion) {
  std::uint64_t hash = 0;
  for (const auto* numbers : {&motion.x, &motion.v})
    for (const double number : *numbers) hash = mix_bits(hash ^ std::bit_cast<std::uint64_t>(number));
  return hash;
}

/// What must be conserved, as shares: of momentum of the sum of its sizes, of energy of the kinetic one at the start.
struct Balance {
  double momentum = 0, energy = 0, absorbed = 0;
};

Balance find_balance(const Box& box, const Motion& start, const Motion& last, const std::vector<double>& before) {
  const auto inverse = to_host(box.inverse_mass);
  double momentum[3] = {0, 0, 0}, size = 0, kinetic = 0, kinetic_start = 0, work = 0;
  for (std::size_t i = 0; i < last.v.size(); ++i) {
    const double mass = 1 / inverse(i / 3, i % 3);
    momentum[i % 3] += mass * (last.v[i] - start.v[i]);
    size += mass * std::fabs(start.v[i]);
    kinetic += 0.5 * mass * before[i] * last.v[i];  // at n, between two velocities
    kinetic_start += 0.5 * mass * start.v[i] * start.v[i];
  }
  const auto by_chunk = to_host(box.fields.results.work);
  for (std::size_t c = 0; c < by_chunk.extent(0); ++c)
    for (std::size_t k = 0; k < 3; ++k) work += by_chunk(c, k);
  const double most = std::max({std::fabs(momentum[0]), std::fabs(momentum[1]), std::fabs(momentum[2])});
  return {most / size, (kinetic + work - kinetic_start) / kinetic_start, work / kinetic_start};
}

/// Compares with what another program wrote, by bits, and by displacements against the largest.
void compare_motion(const Motion& start, const Motion& motion, const std::string& path) {
  Motion other{std::vector<double>(motion.x.size()), std::vector<double>(motion.v.size())};
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  std::size_t read = 0;
  if (file != nullptr) {
    read = std::fread(other.x.data(), sizeof(double), other.x.size(), file);
    read += std::fread(other.v.data(), sizeof(double), other.v.size(), file);
    std::fclose(file);
  }
  if (read != motion.x.size() + motion.v.size()) {
    std::printf("  %s: cannot be read, or is of another box\n", path.c_str());
    return;
  }
  double largest = 0, difference = 0;
  std::size_t differ = 0;
  for (std::size_t i = 0; i < motion.x.size(); ++i) {
    largest = std::max(largest, std::fabs(other.x[i] - start.x[i]));
    difference = std::max(difference, std::fabs(motion.x[i] - other.x[i]));
    if (!has_same_bits(motion.x[i], other.x[i]) || !has_same_bits(motion.v[i], other.v[i])) ++differ;
  }
  std::printf(
      "  against %s: %zu of %zu numbers differ, displacements by %.2e "
      "of the largest\n",
      path.c_str(), differ, motion.x.size(), difference / largest);
}

void write_motion(const Motion& motion, const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return;
  for (const auto* numbers : {&motion.x, &motion.v})
    std::fwrite(numbers->data(), sizeof(double), numbers->size(), file);
  std::fclose(file);
}

/// Each number once, as if no cache held it from kernel to kernel.
struct Bytes {
  double elements, nodes;
};

Bytes count_bytes(const Box& box, int record_size) {
  const auto slots = static_cast<double>(box.chunks.slots_to_nodes.extent(0));
  const double elements = box.element_count, nodes = box.node_count, row = 3 * sizeof(double);
  double corners = 8 * sizeof(std::uint16_t);
  if (is_device)
    corners +=
        8 * sizeof(std::uint16_t) + sizeof(SlotSum) * static_cast<double>(box.slot_corners.sums.extent(0)) / elements;
  return {2.0 * sizeof(Real) * record_size + corners + (slots * (sizeof(int) + row) + nodes * 2 * row) / elements,
          (slots * (sizeof(int) + row) + nodes * (sizeof(int) + 5 * row)) / elements};
}

template <class Material, HexKind Kind>
class Bench {
 public:
  Bench(const Material& material, int cells, const Options& options)
      : options_(options),
        box_(make_box({cells, options.chunk, lanes, hex_record_size<Material, Kind>, 7850})),
        block_{Array<int>("chunks", static_cast<std::size_t>(box_.chunks.count)),
               Kokkos::View<SolidParameters<Material>*, MemSpace>("parameters", 1)} {
    std::vector<int> all;
    for (int c = 0; c < box_.chunks.count; ++c) all.push_back(c);
    block_.chunks = to_view("chunks", all);
    const auto parameters = Kokkos::create_mirror_view(block_.parameters);
    parameters(0) = {material, material.lambda, material.mu, 0.05, {}, 0};
    Kokkos::deep_copy(block_.parameters, parameters);
  }

  void run(const char* name, double triad) {
    const Motion start{list_numbers(box_.x), list_numbers(box_.v)};
    advance_elements(0);
    const double dt = 0.5 * find_least(box_.fields.results.stable_step);
    Kokkos::fence();
    const Kokkos::Timer timer;
    for (int n = 0; n < options_.steps; ++n) take_step(dt);
    Kokkos::fence();
    const double loop = timer.seconds() / options_.steps;
    const std::vector<double> before = list_numbers(box_.v);
    const Motion last = [&] {
      Motion motion{list_numbers(box_.x), {}};
      advance_nodes(dt, 0);
      motion.v = list_numbers(box_.v);
      return motion;
    }();
    print_speed(name, triad, loop);
    const Balance balance = find_balance(box_, start, last, before);
    std::printf(
        "  momentum %.1e, energy %.1e (%.3f of the kinetic energy "
        "absorbed), dt %.6e, hash %016llx\n",
        balance.momentum, balance.energy, balance.absorbed, dt, static_cast<unsigned long long>(hash_bits(last)));
    if (!options_.write.empty()) write_motion(last, options_.write);
    if (!options_.compare.empty()) compare_motion(start, last, options_.compare);
    std::fflush(stdout);
  }

 private:
  void advance_elements(double dt) {
    const ElementMotion motion{box_.x, box_.v, dt};
    if constexpr (is_device)
      advance_by_threads<lanes>(ExecSpace(), box_.chunks, box_.slot_corners, block_, motion, box_.fields);
    else
      advance_block(ExecSpace(), box_.chunks, block_, motion, box_.fields);
  }
  void advance_nodes(double dt_mean, double dt) {
    const NodeForces forces{box_.nodes_to_slots, box_.fields.slot_force, box_.inverse_mass, {}};
    advance_free_nodes(ExecSpace(), forces, dt_mean, dt, box_.v, box_.x);
  }
  /// The next bound goes to the host, as a run needs it there.
  void take_step(double dt) {
    advance_nodes(dt, dt);
    advance_elements(dt);
    if (!(find_least(box_.fields.results.stable_step) > dt)) std::printf("  the step is not stable\n");
  }

  void print_speed(const char* name, double triad, double loop) {
    const double elements = time_median(options_.repeats, [&] { advance_elements(1e-14); });
    const double nodes = time_median(options_.repeats, [&] { advance_nodes(1e-20, 1e-20); });
    const Bytes bytes = count_bytes(box_, hex_record_size<Material, Kind>);
    const double count = box_.element_count;
    std::printf(
        "%-24s %9d elements: forces %8.3f ns %5.0f B %5.1f %%  nodes "
        "%7.3f ns %4.0f B %5.1f %%  step %8.3f ns\n",
        name, box_.element_count, 1e9 * elements / count, bytes.elements,
        100 * bytes.elements * count / elements / triad, 1e9 * nodes / count, bytes.nodes,
        100 * bytes.nodes * count / nodes / triad, 1e9 * loop / count);
  }

  const Options& options_;
  Box box_;
  HexBlock<Material, Kind> block_;
};

template <class Material, HexKind Kind>
void run_bench(const std::string& name, const Material& material, const Options& options, double triad) {
  if (!options.only.empty() && name.find(options.only) == std::string::npos) return;
  for (const int cells : options.cells) Bench<Material, Kind>(material, cells, options).run(name.c_str(), triad);
}

void run_all(const Options& options, double triad) {
  const Elastic elastic = Elastic::make({200e9, 0.3});
  const J2Plasticity j2 = J2Plasticity::make({200e9, 0.3, 400e6, 1e9});
  run_bench<Elastic, HexKind::assumed_strain>("elastic/assumed_strain", elastic, options, triad);
  run_bench<Elastic, HexKind::stiffness>("elastic/stiffness", elastic, options, triad);
  run_bench<J2Plasticity, HexKind::assumed_strain>("j2/assumed_strain", j2, options, triad);
  run_bench<J2Plasticity, HexKind::stiffness>("j2/stiffness", j2, options, triad);
  run_bench<J2Plasticity, HexKind::viscous>("j2/viscous", j2, options, triad);
  run_bench<J2Plasticity, HexKind::full>("j2/full", j2, options, triad);
}

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string key = argv[i], value = argv[i + 1];
    if (key == "--cells")
      options.cells.push_back(std::atoi(value.c_str()));
    else if (key == "--chunk")
      options.chunk = std::atoi(value.c_str());
    else if (key == "--steps")
      options.steps = std::atoi(value.c_str());
    else if (key == "--repeats")
      options.repeats = std::atoi(value.c_str());
    else if (key == "--only")
      options.only = value;
    else if (key == "--write")
      options.write = value;
    else if (key == "--compare")
      options.compare = value;
    else
      std::printf("unknown option %s\n", key.c_str()), std::exit(1);
  }
  if (options.cells.empty()) options.cells = {48};
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  const Kokkos::ScopeGuard kokkos(argc, argv);
  const Options options = read_options(argc, argv);
  for (const int cells : options.cells) {
    if (cells > 0 && options.chunk > 0 && cells % options.chunk == 0 && options.chunk <= 20) continue;
    std::printf("--cells must be a multiple of --chunk, which is at most 20\n");
    return 1;
  }
  const double triad = measure_triad(options.repeats);
  std::printf(
      "%s, %s, %d lanes, chunks of %d; triad %.0f GB/s; %% of it; ns "
      "and bytes: of an element and step\n",
      ExecSpace::name(), precision_name, lanes, options.chunk * options.chunk * options.chunk, triad * 1e-9);
  std::fflush(stdout);
  run_all(options, triad);
  return 0;
}
