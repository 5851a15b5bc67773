// Measures what limits the step: stability_tool matrices DECK SHAPES OUT, or search DECK LOW HIGH TOLERANCE NOISE.
// perf/stability/run drives it. Shapes and matrices are raw doubles, trials JSON lines on standard output.

#include <fmt/format.h>

#include <Kokkos_Core.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

#include "comm/communicator.hpp"
#include "perf/stability/bounded_run.hpp"
#include "perf/stability/linear_operators.hpp"
#include "src/deck/reading/read_deck.hpp"

namespace percuss {

namespace {

std::vector<LinearShape> read_shapes(const Deck& deck, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const auto read = [&] {
    double value = 0;
    file.read(reinterpret_cast<char*>(&value), sizeof value);
    return value;
  };
  std::vector<LinearShape> shapes;
  for (const PartDeck& part : deck.parts) {
    const auto side = static_cast<std::size_t>(std::get<BoxShape>(part.shape).cells[0]) + 1;
    LinearShape shape{std::vector<Vec3>(side * side * side), read()};
    for (Vec3& node : shape.nodes) {
      for (double& x : node) x = read();
    }
    shapes.push_back(shape);
  }
  if (!file) throw std::runtime_error(path + " is shorter than the parts of the deck need");
  return shapes;
}

void write_row(std::ofstream& file, const std::vector<double>& row) {
  file.write(reinterpret_cast<const char*>(row.data()), static_cast<std::streamsize>(row.size() * sizeof(double)));
}

/// For each part: its bound, masses, stiffness and damping.
void write_matrices(const std::string& deck_path, const std::string& shapes_path, const std::string& out_path) {
  const Deck deck = read_deck(deck_path);
  std::ofstream file(out_path, std::ios::binary);
  for (const LinearPart& part : find_linear_parts(deck, read_shapes(deck, shapes_path))) {
    write_row(file, {part.bound});
    write_row(file, part.mass);
    write_row(file, part.stiffness);
    write_row(file, part.damping);
  }
  if (!file.flush()) throw std::runtime_error(out_path + " cannot be written");
}

void print_search(const std::string& deck_path, double low, double high, double tolerance, double noise) {
  for (const BoundedRun& t : search_largest_scale(read_deck(deck_path), low, high, tolerance, noise)) {
    fmt::print(
        "{{\"scale\": {}, \"bounded\": {}, \"outcome\": \"{}\", \"steps\": {}, \"energy_error\": {:.3e}, \"growth\": "
        "{:.3e}}}\n",
        t.scale, t.is_bounded, t.outcome.substr(0, t.outcome.find_first_of("\"\n\\")), t.steps, t.energy_error,
        t.growth);
  }
}

int run_tool(int argc, char** argv) {
  const std::string task = argc > 1 ? argv[1] : "";
  if (task == "matrices" && argc == 5) {
    write_matrices(argv[2], argv[3], argv[4]);
  } else if (task == "search" && argc == 7) {
    print_search(argv[2], std::stod(argv[3]), std::stod(argv[4]), std::stod(argv[5]), std::stod(argv[6]));
  } else {
    fmt::print(stderr, "stability_tool matrices DECK SHAPES OUT | search DECK LOW HIGH TOLERANCE NOISE\n");
    return 2;
  }
  return 0;
}

}  // namespace

}  // namespace percuss

int main(int argc, char** argv) {
  const percuss::MpiSession mpi(argc, argv);
  const Kokkos::ScopeGuard kokkos;
  try {
    return percuss::run_tool(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "stability_tool: error: {}\n", error.what());
    return 1;
  }
}
