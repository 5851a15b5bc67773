#include "src/step/results/fields/element_fields.hpp"

#include <cmath>

#include "kernels/core/common_record.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/element/failure_criteria.hpp"
#include "kernels/element/hex8/point_mean.hpp"
#include "src/step/results/fields/beam_fields.hpp"
#include "src/step/results/fields/shell_fields.hpp"

namespace percuss {

namespace {

/// Data besides the record for reading an element.
struct Lives {
  FailingChunks failing;
  ElementLives lives;

  /// Place of element i of chunk c among the lanes that can fail; -1: it cannot.
  KOKKOS_INLINE_FUNCTION int find_lane(int c, int i) const {
    const int pack = failing.find_pack(c);
    return pack < 0 ? -1 : pack * pack_width + i;
  }
  /// Share of its force that an element has at n.
  KOKKOS_INLINE_FUNCTION double find_share(int c, int i) const {
    const int lane = find_lane(c, i);
    if (lane < 0) return 1;
    if (lives.steps_left(lane) == ElementLives::whole)  // work takes the mean of the shares of now and of the next step
      return 2 * static_cast<double>(lives.work_share(lane)) - static_cast<double>(lives.force_share(lane));
    return find_life_shares(lives.steps_left(lane), failing.limits(failing.row(c)).fade_steps).now;
  }
  /// is_of_layers: of a shell, whose damage is a mean already.
  KOKKOS_INLINE_FUNCTION double find_damage(int c, int i, bool is_of_layers) const {
    const int lane = find_lane(c, i);
    if (lane < 0) return 0;
    const FailureLimits& limits = failing.find_limits(c, i);
    if (lives.steps_left(lane) != ElementLives::whole) return limits.whole_damage();
    const double strain = smaller(lives.plastic_strain(lane) / limits.plastic_strain, 1.0),
                 time = lives.second(lane) / limits.yield_time;
    const FailureHistory history{0, lives.damage(lane), lives.second(lane)};
    const double damage = is_of_layers ? history.damage : find_shown_damage(limits, history);
    return larger(damage, larger(strain, time));
  }
};

KOKKOS_INLINE_FUNCTION int find_chunk(const ElementChunks& chunks, int e) {
  int low = 0, high = chunks.count;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (chunks.first_element(middle) <= e ? low : high) = middle;
  }
  return low;
}

/// The stress, turned into space axes; of a hexahedron with several points their mean, of a beam that of its section.
struct ReadStress {
  static constexpr int components = 6;
  static constexpr bool fades = true;
  ShellTables shells;
  BeamTables beams;
  int point = ShellPoint::mean;
  bool is_of_solids = false;  // whether hexahedra have points, too
  KOKKOS_INLINE_FUNCTION void operator()(const ElementChunks& chunks, int c, int e, const ElementRecord& record,
                                         double* row) const {
    if (is_shell(chunks, c)) {
      read_shell_stress(shells, {chunks, c, e, record}, point, row);
      return;
    }
    if (is_beam(chunks, c)) {
      read_beam_stress(beams, chunks, c, e, record, row);
      return;
    }
    const ElementRecord s = record.from(SolidRecord::stress);
    const ElementRecord r = record.from(SolidRecord::rotation);
    const int points = chunks.points(c);
    const bool is_one = is_of_solids && point >= 0 && point < points;
    double mean[6];
    for (int k = 0; k < 6; ++k) {
      const auto value = [&](int p) { return double{s[6 * p + k]}; };
      mean[k] = is_one ? value(point) : find_point_mean(points, value);
    }
    const Symmetric3<double> stress{mean[0], mean[1], mean[2], mean[3], mean[4], mean[5]};
    Matrix3<double> rotation{};
    for (int i = 0; i < 3; ++i) {
      rotation.row[i] = {r[3 * i], r[3 * i + 1], r[3 * i + 2]};
    }
    const Symmetric3<double> t = push_forward(rotation, stress);
    row[0] = t.xx;
    row[1] = t.yy;
    row[2] = t.zz;
    row[3] = t.xy;
    row[4] = t.yz;
    row[5] = t.zx;
  }
};

/// A scalar of the history; of an element with several points their mean, of a beam the largest plastic strain, 0 where
/// the material has none.
struct ReadScalar {
  static constexpr int components = 1;
  static constexpr bool fades = false;
  ShellTables shells;
  HistoryScalar name;
  int point = ShellPoint::mean;
  bool is_of_solids = false;
  KOKKOS_INLINE_FUNCTION void operator()(const ElementChunks& chunks, int c, int e, const ElementRecord& record,
                                         double* row) const {
    if (is_shell(chunks, c)) {
      const auto& rule = shells.rules(chunks.rule(c));
      const int place = chunks.find_scalar(c, name);
      const auto whole = [](int) { return 1.0; };
      const bool has = place >= 0 && point < rule.count;
      row[0] = has ? read_layers({chunks, c, e, record}, rule, place - ShellRecord::layers, point, whole) : 0;
      return;
    }
    if (is_beam(chunks, c)) {
      const bool has = name == HistoryScalar::equivalent_plastic_strain;
      row[0] = has ? read_beam_plastic_strain(chunks, c, record) : 0;
      return;
    }
    const int place = chunks.find_scalar(c, name);
    const int points = place < 0 ? 0 : chunks.points(c);
    row[0] = 0;
    if (is_of_solids && point >= 0 && point < points) {
      row[0] = record[place + point];
      return;
    }
    if (points > 0) row[0] = find_point_mean(points, [&](int p) { return double{record[place + p]}; });
  }
};

/// A state variable, from 0; the mean of an element's points, 0 where its law has none of this number.
struct ReadStateVariable {
  static constexpr int components = 1;
  static constexpr bool fades = false;
  int number;
  KOKKOS_INLINE_FUNCTION void operator()(const ElementChunks& chunks, int c, int /*e*/, const ElementRecord& record,
                                         double* row) const {
    row[0] = 0;
    const int first = chunks.find_scalar(c, HistoryScalar::first_state), points = chunks.points(c);
    if (first < 0) return;
    const int place = first + number * points;
    if (place >= chunks.find_scalar(c, HistoryScalar::after_states)) return;
    row[0] = find_point_mean(points, [&](int p) { return double{record[place + p]}; });
  }
};

/// Thickness of a shell; 0 for others.
struct ReadThickness {
  static constexpr int components = 1;
  static constexpr bool fades = false;
  KOKKOS_INLINE_FUNCTION void operator()(const ElementChunks& chunks, int c, int /*e*/, const ElementRecord& record,
                                         double* row) const {
    row[0] = is_shell(chunks, c) ? record[ShellRecord::thickness] : 0;
  }
};

/// Forces of the section of a beam from `first` on; 0 of others.
template <int Count>
struct ReadBeamForces {
  static constexpr int components = Count;
  static constexpr bool fades = true;
  int first = 0;
  KOKKOS_INLINE_FUNCTION void operator()(const ElementChunks& chunks, int c, int /*e*/, const ElementRecord& record,
                                         double* row) const {
    for (int k = 0; k < Count; ++k) row[k] = is_beam(chunks, c) ? double{record[BeamRecord::forces + first + k]} : 0;
  }
};

/// Scales a row by what the element has lost.
template <class Read>
KOKKOS_INLINE_FUNCTION void scale(const Lives& lives, int c, int i, double* row) {
  const double share = lives.find_share(c, i);
  if (share == 1) return;
  for (int k = 0; k < Read::components; ++k) {
    if (Read::fades) row[k] *= share;
    if (share == 0) row[k] = 0;  // also of a record that is not finite
  }
}

std::vector<double> copy_out(const Array<double>& view) {
  const auto host = to_host(view);
  return {host.data(), host.data() + host.extent(0)};
}

template <class Read>
std::vector<double> read_all(const Model& model, const State& state, const Read& read) {
  const Array<double> out("percuss::element_field", Read::components * static_cast<std::size_t>(model.element_count));
  const ElementChunks chunks = model.chunks;
  const auto elements = state.elements;
  const Lives lives{model.failing, state.lives};
  parallel_for(
      "percuss::read_elements", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        for (int e = chunks.first_element(c); e < chunks.first_element(c + 1); ++e) {
          double* const row = &out(Read::components * static_cast<std::size_t>(e));
          read(chunks, c, e, find_record(chunks, elements, c, e - chunks.first_element(c)), row);
          scale<Read>(lives, c, e - chunks.first_element(c), row);
        }
      });
  return copy_out(out);
}

template <class Read>
std::vector<double> read_some(const Model& model, const State& state, const std::vector<int>& wanted,
                              const Read& read) {
  const Array<double> out("percuss::element_values", Read::components * wanted.size());
  const Array<int> list = to_view("percuss::wanted_elements", wanted);
  const ElementChunks chunks = model.chunks;
  const auto elements = state.elements;
  const Lives lives{model.failing, state.lives};
  parallel_for(
      "percuss::read_some_elements", RangeOf(ExecSpace(), 0, static_cast<int>(wanted.size())),
      KOKKOS_LAMBDA(const int i) {
        const int c = find_chunk(chunks, list(i));
        double* const row = &out(Read::components * static_cast<std::size_t>(i));
        read(chunks, c, list(i), find_record(chunks, elements, c, list(i) - chunks.first_element(c)), row);
        scale<Read>(lives, c, list(i) - chunks.first_element(c), row);
      });
  return copy_out(out);
}

template <class Read>
std::vector<double> read_chosen(const Model& model, const State& state, const ElementChoice& of, const Read& read) {
  return of.some() == nullptr ? read_all(model, state, read) : read_some(model, state, *of.some(), read);
}

/// read(lives, chunk, i) of elements.
template <class Read>
std::vector<double> read_lives(const Model& model, const State& state, const ElementChoice& of, const Read& read) {
  const bool is_of_all = of.some() == nullptr;
  const std::size_t count = is_of_all ? static_cast<std::size_t>(model.element_count) : of.some()->size();
  const Array<double> out("percuss::element_field", count);
  const ElementChunks chunks = model.chunks;
  const Lives lives{model.failing, state.lives};
  if (!is_of_all) {
    const Array<int> list = to_view("percuss::wanted_elements", *of.some());
    parallel_for(
        "percuss::read_some_lives", RangeOf(ExecSpace(), 0, static_cast<int>(count)), KOKKOS_LAMBDA(const int i) {
          const int c = find_chunk(chunks, list(i));
          out(i) = read(lives, c, list(i) - chunks.first_element(c));
        });
    return copy_out(out);
  }
  parallel_for(
      "percuss::read_lives", RangeOf(ExecSpace(), 0, chunks.count), KOKKOS_LAMBDA(const int c) {
        const int first = chunks.first_element(c);
        for (int e = first; e < chunks.first_element(c + 1); ++e) out(e) = read(lives, c, e - first);
      });
  return copy_out(out);
}

ReadScalar read_plastic_strain(const Model& model, const State& state, int point = ShellPoint::mean) {
  return {{model, state}, HistoryScalar::equivalent_plastic_strain, point};
}

}  // namespace

std::vector<double> find_alive(const Model& model, const State& state, const ElementChoice& of) {
  return read_lives(model, state, of,
                    [](const Lives& lives, int c, int i) { return lives.find_share(c, i) > 0 ? 1.0 : 0.0; });
}

std::vector<double> find_damage(const Model& model, const State& state, const ElementChoice& of) {
  return read_lives(model, state, of, [chunks = model.chunks](const Lives& lives, int c, int i) {
    return lives.find_damage(c, i, is_shell(chunks, c));
  });
}

std::vector<double> find_stresses(const Model& model, const State& state, const ElementChoice& of) {
  return read_chosen(model, state, of, ReadStress{{model, state}, {model, state}});
}

std::vector<double> find_point_stresses(const Model& model, const State& state, int point, const ElementChoice& of) {
  return read_chosen(model, state, of, ReadStress{{model, state}, {model, state}, point});
}

std::vector<double> find_thicknesses(const Model& model, const State& state, const ElementChoice& of) {
  return read_chosen(model, state, of, ReadThickness{});
}

std::vector<double> find_axial_forces(const Model& model, const State& state, const ElementChoice& of) {
  return read_chosen(model, state, of, ReadBeamForces<1>{});
}

std::vector<double> find_section_forces(const Model& model, const State& state, const ElementChoice& of) {
  return read_chosen(model, state, of, ReadBeamForces<3>{});
}

std::vector<double> find_section_moments(const Model& model, const State& state, const ElementChoice& of) {
  return read_chosen(model, state, of, ReadBeamForces<3>{3});
}

std::vector<double> find_section_results(const Model& model, const State& state, const ElementChoice& of) {
  return read_chosen(model, state, of, ReadBeamForces<6>{});
}

std::vector<double> find_plastic_strains(const Model& model, const State& state, const ElementChoice& of) {
  return read_chosen(model, state, of, read_plastic_strain(model, state));
}

std::vector<double> find_point_plastic_strains(const Model& model, const State& state, int point,
                                               const ElementChoice& of) {
  return read_chosen(model, state, of, read_plastic_strain(model, state, point));
}

std::vector<double> find_history(const Model& model, const State& state, HistoryScalar name, const ElementChoice& of,
                                 int point) {
  return read_chosen(model, state, of, ReadScalar{{model, state}, name, point});
}

std::vector<double> find_state_variables(const Model& model, const State& state, int number, const ElementChoice& of) {
  return read_chosen(model, state, of, ReadStateVariable{number});
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

std::vector<double> find_point_stress(const Model& model, const State& state, const ElementPoint& of) {
  return read_some(model, state, {of.element}, ReadStress{{model, state}, {model, state}, of.point, true});
}

double find_point_plastic_strain(const Model& model, const State& state, const ElementPoint& of) {
  const ReadScalar read{{model, state}, HistoryScalar::equivalent_plastic_strain, of.point, true};
  return read_some(model, state, {of.element}, read)[0];
}

int count_points(const Model& model, int element) {
  const ElementChunks& chunks = model.chunks;
  const auto first_element = to_host(chunks.first_element);
  int chunk = 0;
  while (first_element(static_cast<std::size_t>(chunk) + 1) <= element) ++chunk;
  return to_host(chunks.points)(static_cast<std::size_t>(chunk));
}

}  // namespace percuss
