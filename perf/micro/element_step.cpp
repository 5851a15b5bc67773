// What one element costs in one step: the kernel of each material and kind of element, and the pass over the nodes, in
// nanoseconds of a thread, bytes and operations, and as a share of what this machine could do (the larger of the times
// that its operations and its bytes need at least). docs/notes_performance.md, "The element step".
//
// usage: element_step [option of Google Benchmark]; PERCUSS_MICRO_CELLS: edge of the block (40: 64 000 elements)

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "comm/communicator.hpp"
#include "perf/micro/ceilings.hpp"
#include "perf/micro/operation_counts.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/step/model/element_blocks.hpp"
#include "src/step/model/state.hpp"

namespace {

using namespace percuss;

Ceilings ceilings;

int find_cells() {
  const char* cells = std::getenv("PERCUSS_MICRO_CELLS");
  return cells == nullptr ? 40 : std::atoi(cells);
}

/// A cube of cells that spins.
Deck make_deck(const std::string& material, const std::string& element) {
  const int n = find_cells();
  const std::string plastic = material == "elastic" ? "" : ", yield_stress: 400e6, hardening_modulus: 1e9";
  const std::string kind = element == "full" ? "{integration: full}" : "{hourglass: " + element + "}";
  return parse_deck(fmt::format(R"(
title: A block
units: m, kg, s
time: {{end: 1}}
parts: {{block: {{box: {{size: [1, 1, 1], cells: [{0}, {0}, {0}]}}, material: steel}}}}
materials: {{steel: {{model: {1}, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3{2}}}}}
elements: {3}
initial: [{{part: block, angular_velocity: [100, 30, 50]}}]
)",
                                n, material, plastic, kind),
                    "element_step");
}

/// The block between two steps.
struct Block {
  Deck deck;
  ChunkedMesh chunked;
  Model model;
  State state;

  Block(const std::string& material, const std::string& element)
      : deck(make_deck(material, element)),
        chunked(load_mesh(deck, Communicator::world())),
        model(build_model(deck, chunked)),
        state(make_initial_state(model)) {
    advance(0);
  }

  void advance(double dt) {
    advance_elements(ExecSpace(), model.chunks, model.others->hexahedra, {state.x, state.v, dt}, state.chunk_fields());
  }
};

/// Each number once: what has to come from memory and go back to it if no cache holds it from step to step.
double count_element_bytes(const Block& block) {
  const double slots = static_cast<double>(block.model.chunks.slots_to_nodes.extent(0));
  const double nodes = block.model.node_count, elements = block.model.element_count;
  const double state = 2 * sizeof(Real) * static_cast<double>(block.model.state_size);
  return (state + slots * (sizeof(int) + 3 * sizeof(double)) + nodes * 6 * sizeof(double)) / elements +
         8 * sizeof(std::uint16_t);
}

double count_node_bytes(const Block& block) {
  const double slots = static_cast<double>(block.model.chunks.slots_to_nodes.extent(0));
  const double nodes = block.model.node_count, elements = block.model.element_count;
  return (slots * (sizeof(int) + 3 * sizeof(double)) + nodes * (sizeof(int) + 15 * sizeof(double))) / elements;
}

void report(benchmark::State& run, const Block& block, double flop, double bytes) {
  const double elements = static_cast<double>(run.iterations()) * block.model.element_count;
  const double least = std::max(flop / ceilings.flops, bytes / ceilings.stream);
  using benchmark::Counter;
  run.counters["element"] = Counter(elements, Counter::kIsRate | Counter::kInvert);
  run.counters["bytes"] = bytes;
  run.counters["flop"] = flop;
  run.counters["roofline"] = Counter(elements * least, Counter::kIsRate);
}

void advance_elements(benchmark::State& run, const std::string& material, const std::string& element) {
  Block block(material, element);
  const double dt = 1e-9;  // the shape stays what it is however often this runs
  for (auto _ : run) block.advance(dt);
  const auto flop = static_cast<double>(count_operations(material, element).all());
  report(run, block, flop, count_element_bytes(block));
}

void advance_nodes(benchmark::State& run) {
  Block block("elastic", "stiffness");
  const NodeForces forces{block.model.nodes_to_slots, block.state.slot_force, block.model.inverse_mass,
                          find_gravity(block.model, 0)};
  for (auto _ : run) advance_free_nodes(ExecSpace(), forces, 1e-12, 1e-12, block.state.v, block.state.x);
  const double slots = static_cast<double>(block.model.chunks.slots_to_nodes.extent(0));
  const double nodes = block.model.node_count, elements = block.model.element_count;
  report(run, block, (3 * slots + 15 * nodes) / elements, count_node_bytes(block));
}

void register_all() {
  for (const std::string material : {"elastic", "j2_plasticity"}) {
    for (const std::string element : {"assumed_strain", "stiffness", "viscous", "full"}) {
      const auto run = [=](benchmark::State& state) { advance_elements(state, material, element); };
      benchmark::RegisterBenchmark(("elements/" + material + "/" + element).c_str(), run);
    }
  }
  benchmark::RegisterBenchmark("nodes", advance_nodes);
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession mpi(argc, argv);
  const Kokkos::ScopeGuard kokkos;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  ceilings = measure_ceilings();
  const int threads = ExecSpace().concurrency();
  fmt::print("one thread at most: {:.1f} Gflop/s, {:.1f} GB/s; {} thread{}; element: CPU time of an element and step\n",
             ceilings.flops * 1e-9, ceilings.stream * 1e-9, threads, threads == 1 ? "" : "s");
  ceilings = {threads * ceilings.flops, threads * ceilings.stream};
  register_all();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
