#include "perf/device/box_chunks.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "kernels/core/counting_sort.hpp"
#include "kernels/core/host_copy.hpp"

namespace percuss {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Row = std::array<double, 3>;

/// Numbers of the nodes: chunk by chunk, in the order of first use.
class BoxMesh {
 public:
  explicit BoxMesh(const BoxPlan& plan)
      : cells(plan.cells),
        edge(plan.chunk_cells),
        along(cells / edge),
        nodes_(at((cells + 1) * (cells + 1) * (cells + 1)), -1) {
    slots.reserve(at(chunk_count()) * at((edge + 1) * (edge + 1) * (edge + 1)));
    for (int c = 0; c < chunk_count(); ++c) number_nodes(c);
  }

  int chunk_count() const { return along * along * along; }
  int chunk_elements() const { return edge * edge * edge; }
  int chunk_slots() const { return (edge + 1) * (edge + 1) * (edge + 1); }
  int node_count() const { return static_cast<int>(places.size()); }

  /// Slot of corner i of an element of a chunk, in Exodus order.
  int find_slot(int element, int i) const {
    constexpr int across[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                  {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const int x = element % edge + across[i][0], y = element / edge % edge + across[i][1],
              z = element / edge / edge + across[i][2];
    return x + (edge + 1) * (y + (edge + 1) * z);
  }

  int cells, edge, along;
  std::vector<int> slots;   // [slots] node
  std::vector<Row> places;  // [nodes] in cells

 private:
  void number_nodes(int c) {
    const int first[3] = {c % along * edge, c / along % along * edge, c / along / along * edge};
    for (int z = first[2]; z <= first[2] + edge; ++z) {
      for (int y = first[1]; y <= first[1] + edge; ++y) {
        for (int x = first[0]; x <= first[0] + edge; ++x) {
          int& node = nodes_[at(x + (cells + 1) * (y + (cells + 1) * z))];
          if (node < 0) {
            node = node_count();
            places.push_back({1.0 * x, 1.0 * y, 1.0 * z});
          }
          slots.push_back(node);
        }
      }
    }
  }

  std::vector<int> nodes_;
};

std::vector<int> count_up(int chunks, int step) {
  std::vector<int> first;
  for (int c = 0; c <= chunks; ++c) first.push_back(c * step);
  return first;
}

template <class T>
std::vector<T> repeat(const std::vector<T>& values, int times) {
  std::vector<T> all;
  all.reserve(values.size() * at(times));
  for (int i = 0; i < times; ++i) all.insert(all.end(), values.begin(), values.end());
  return all;
}

int count_packs(const BoxMesh& mesh, const BoxPlan& plan) {
  return (mesh.chunk_elements() + plan.lanes - 1) / plan.lanes;
}

std::vector<std::uint16_t> list_corner_slots(const BoxMesh& mesh, const BoxPlan& plan) {
  std::vector<std::uint16_t> of_chunk;
  for (int p = 0; p < count_packs(mesh, plan); ++p) {
    for (int i = 0; i < 8; ++i) {
      for (int lane = 0; lane < plan.lanes; ++lane) {
        const int element = std::min(p * plan.lanes + lane, mesh.chunk_elements() - 1);
        of_chunk.push_back(static_cast<std::uint16_t>(mesh.find_slot(element, i)));
      }
    }
  }
  return repeat(of_chunk, mesh.chunk_count());
}

ElementChunks make_chunks(const BoxMesh& mesh, const BoxPlan& plan) {
  const int count = mesh.chunk_count(), packs = count_packs(mesh, plan);
  ElementChunks chunks;
  chunks.count = count;
  chunks.largest_slot_count = mesh.chunk_slots();
  chunks.first_element = to_view("first_element", count_up(count, mesh.chunk_elements()));
  chunks.first_slot = to_view("first_slot", count_up(count, mesh.chunk_slots()));
  chunks.slots_to_nodes = to_view("slots_to_nodes", mesh.slots);
  chunks.first_pack = to_view("first_pack", count_up(count, packs));
  chunks.corner_slots = to_view("corner_slots", list_corner_slots(mesh, plan));
  std::vector<std::size_t> first_state;
  for (int c = 0; c < count; ++c) first_state.push_back(at(c) * at(packs) * at(plan.lanes * plan.record_size));
  chunks.first_state = to_view("first_state", first_state);
  chunks.parameters = Array<int>("parameters", at(count));
  chunks.record_size = to_view("record_size", std::vector<int>(at(count), plan.record_size));
  return chunks;
}

/// Sums of the nodes of one chunk; all chunks are alike.
struct ChunkSums {
  std::vector<int> first_sum;  // [rounds]
  std::vector<SlotSum> sums;
  std::vector<std::uint16_t> corners;
};

ChunkSums list_chunk_sums(const BoxMesh& mesh) {
  ChunkSums list;
  std::vector<bool> begun(at(mesh.chunk_slots()), false);
  for (int begin = 0; begin < mesh.chunk_elements(); begin += round_elements) {
    const int end = std::min(begin + round_elements, mesh.chunk_elements());
    const auto by_slot = collect_buckets<int>(at(mesh.chunk_slots()), [&](auto&& put) {
      for (int e = begin; e < end; ++e)
        for (int i = 0; i < 8; ++i) put(at(mesh.find_slot(e, i)), 8 * e + i);
    });
    list.first_sum.push_back(static_cast<int>(list.sums.size()));
    for (std::size_t s = 0; s < begun.size(); ++s) {
      if (by_slot.first[s] == by_slot.first[s + 1]) continue;
      const std::size_t mark = begun[s] ? SlotSum::continues : 0;
      list.sums.push_back(
          {static_cast<std::uint16_t>(s + mark), static_cast<std::uint16_t>(8 * begin + by_slot.first[s + 1])});
      begun[s] = true;
    }
    for (const int corner : by_slot.items) list.corners.push_back(static_cast<std::uint16_t>(corner));
  }
  return list;
}

SlotCorners list_slot_corners(const BoxMesh& mesh) {
  const ChunkSums of_chunk = list_chunk_sums(mesh);
  const int count = mesh.chunk_count(), sums = static_cast<int>(of_chunk.sums.size());
  std::vector<int> first_sum;
  for (int c = 0; c < count; ++c)
    for (const int first : of_chunk.first_sum) first_sum.push_back(c * sums + first);
  first_sum.push_back(count * sums);
  return {to_view("first_round", count_up(count, static_cast<int>(of_chunk.first_sum.size()))),
          to_view("first_sum", first_sum), to_view("slot_sums", repeat(of_chunk.sums, count)),
          to_view("slot_corners", repeat(of_chunk.corners, count))};
}

/// In units of the box; the distortion is a share of a cell.
std::vector<Row> place_nodes(const BoxMesh& mesh) {
  std::vector<Row> x;
  x.reserve(mesh.places.size());
  const double h = 1.0 / mesh.cells;
  for (const Row& p : mesh.places) {
    const double a = h * p[0], b = h * p[1], c = h * p[2];
    x.push_back({a + 0.1 * b * (1 - c), b + 0.08 * c * (1 - a), c + 0.06 * a * (1 - b)});
  }
  return x;
}

std::vector<Row> start_velocities(const std::vector<Row>& places) {
  constexpr double spin[3] = {100, 30, 50}, speed = 40;
  std::vector<Row> v;
  v.reserve(places.size());
  for (const Row& p : places) {
    const double a = p[0] - 0.5, b = p[1] - 0.5, c = p[2] - 0.5;
    v.push_back({spin[1] * c - spin[2] * b + speed * 4 * a * b, spin[2] * a - spin[0] * c + speed * 4 * b * c,
                 spin[0] * b - spin[1] * a - speed * 8 * a * c * c});
  }
  return v;
}

double find_element_volume(const BoxMesh& mesh, const std::vector<Row>& x, int chunk, int element) {
  double u[3][8];
  for (int i = 0; i < 8; ++i) {
    const Row& row = x[at(mesh.slots[at(chunk * mesh.chunk_slots() + mesh.find_slot(element, i))])];
    for (std::size_t k = 0; k < 3; ++k) u[k][i] = row[k];
  }
  VectorModes<double> modes;
  for (auto& of : u) to_modes(of);
  for (int m = 1; m < 8; ++m) modes[m] = {u[0][m], u[1][m], u[2][m]};
  return find_volume_gradient(modes).volume;
}

/// Records of elements without stress; adds their masses to those of the nodes.
std::vector<Real> start_records(const BoxMesh& mesh, const BoxPlan& plan, const std::vector<Row>& x,
                                std::vector<double>& node_mass) {
  const int packs = count_packs(mesh, plan), lanes = plan.lanes;
  std::vector<Real> state(at(mesh.chunk_count()) * at(packs) * at(lanes * plan.record_size), Real(0));
  for (int c = 0; c < mesh.chunk_count(); ++c) {
    for (int place = 0; place < packs * lanes; ++place) {
      const int element = std::min(place, mesh.chunk_elements() - 1);
      const double mass = plan.density * find_element_volume(mesh, x, c, element);
      Real* const record =
          &state[(at(c) * at(packs) + at(place / lanes)) * at(lanes * plan.record_size) + at(place % lanes)];
      record[HexRecord::mass * lanes] = static_cast<Real>(mass);
      for (int k = 0; k < 3; ++k)
        record[(HexRecord::rotation + 4 * k) * lanes] = record[(HexRecord::stretch + k) * lanes] = Real(1);
      if (place != element) continue;
      for (int i = 0; i < 8; ++i)
        node_mass[at(mesh.slots[at(c * mesh.chunk_slots() + mesh.find_slot(element, i))])] += mass / 8;
    }
  }
  return state;
}

ChunkFields make_fields(const BoxMesh& mesh, const std::vector<Real>& state) {
  const std::size_t count = at(mesh.chunk_count());
  return {to_view("state", state),
          Rows3<double>("slot_force", mesh.slots.size()),
          {Array<double>("stable_step", count), Array<int>("controlling", count), Array<int>("failed", count),
           WorkRows("work", count), Array<int>("is_settled", count), Array<std::int64_t>("skipped", count),
           Array<double>()}};
}

}  // namespace

Box make_box(const BoxPlan& plan) {
  const BoxMesh mesh(plan);
  const std::vector<Row> x = place_nodes(mesh);
  std::vector<double> mass(x.size(), 0.0);
  Box box;
  box.node_count = mesh.node_count();
  box.element_count = mesh.chunk_count() * mesh.chunk_elements();
  box.chunks = make_chunks(mesh, plan);
  box.slot_corners = list_slot_corners(mesh);
  const Buckets of_nodes = sort_into_buckets(mesh.slots, x.size());
  box.nodes_to_slots = {to_view("first_node_slot", of_nodes.first), to_view("node_slots", of_nodes.items)};
  box.fields = make_fields(mesh, start_records(mesh, plan, x, mass));
  std::vector<Row> inverse;
  inverse.reserve(mass.size());
  for (const double m : mass) inverse.push_back({1 / m, 1 / m, 1 / m});
  box.inverse_mass = to_rows("inverse_mass", inverse);
  box.x = to_rows("x", x);
  box.v = to_rows("v", start_velocities(x));
  return box;
}

}  // namespace percuss
