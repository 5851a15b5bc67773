#include "src/step/element_fields.hpp"

#include <cmath>

#include "kernels/core/host_copy.hpp"

namespace percuss {

namespace {

constexpr int width = pack_size<double>;

/// Calls write(element, record) for each element; record[width * i] is scalar i of its record.
template <class Write>
void for_each_record(const Model& model, const State& state, const Write& write) {
  const HexChunks chunks = model.chunks;
  const auto elements = state.elements;
  Kokkos::parallel_for(
      "percuss::read_elements", Range(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        const int first = chunks.first_element(c);
        const int size = chunks.record_size(c);
        const double* base = &elements(chunks.first_state(c));
        for (int e = first; e < chunks.first_element(c + 1); ++e) {
          write(e, c,
                base + static_cast<std::size_t>((e - first) / width) * static_cast<std::size_t>(size) * width +
                    (e - first) % width);
        }
      });
  ExecSpace().fence();
}

std::vector<double> copy_out(const Array<double>& view) {
  const auto host = to_host(view);
  return {host.data(), host.data() + host.extent(0)};
}

}  // namespace

std::vector<double> find_stresses(const Model& model, const State& state) {
  const Array<double> out("percuss::stress_field", 6 * static_cast<std::size_t>(model.element_count));
  for_each_record(
      model, state, KOKKOS_LAMBDA(const int e, const int, const double* record) {
        const double* s = record + HexRecord::stress * width;
        const double* r = record + HexRecord::rotation * width;
        const Symmetric3<double> stress{s[0], s[width], s[2 * width], s[3 * width], s[4 * width], s[5 * width]};
        Matrix3<double> rotation{};
        for (int i = 0; i < 3; ++i) {
          rotation.row[i] = {r[3 * i * width], r[(3 * i + 1) * width], r[(3 * i + 2) * width]};
        }
        const Symmetric3<double> t = push_forward(rotation, stress);
        double* row = &out(6 * static_cast<std::size_t>(e));
        row[0] = t.xx;
        row[1] = t.yy;
        row[2] = t.zz;
        row[3] = t.xy;
        row[4] = t.yz;
        row[5] = t.zx;
      });
  return copy_out(out);
}

std::vector<double> find_plastic_strains(const Model& model, const State& state) {
  const Array<double> out("percuss::plastic_strain_field", static_cast<std::size_t>(model.element_count));
  const HexChunks chunks = model.chunks;
  for_each_record(
      model, state, KOKKOS_LAMBDA(const int e, const int c, const double* record) {
        const int place = chunks.history(c);
        out(static_cast<std::size_t>(e)) = place < 0 ? 0 : record[place * width];
      });
  return copy_out(out);
}

std::vector<double> find_pressures(const std::vector<double>& stresses) {
  std::vector<double> out(stresses.size() / 6);
  for (std::size_t e = 0; e < out.size(); ++e) {
    const double* s = &stresses[6 * e];
    out[e] = -(s[0] + s[1] + s[2]) / 3;
  }
  return out;
}

std::vector<double> find_von_mises(const std::vector<double>& stresses) {
  std::vector<double> out(stresses.size() / 6);
  for (std::size_t e = 0; e < out.size(); ++e) {
    const double* s = &stresses[6 * e];
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    out[e] = std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
  }
  return out;
}

}  // namespace percuss
